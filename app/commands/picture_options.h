// SPDX-License-Identifier: Apache-2.0
// The options of light and camera, which view, capture and bench have in common.
#pragma once
#include <optional>
#include <string>

#include "app/session/shot.h"

namespace CLI {
class App;
}

namespace demolish {

struct PictureOptions {
    std::string environment, floor, tone, look;  ///< "" = the scene's
    std::optional<double> environment_turn, hour, exposure, white_balance, aperture, focus;
};

void addPictureOptions(CLI::App& command, PictureOptions& options);

/// Of captures alone, which have the time for it.
struct FilmOptions {
    std::optional<double> shutter, samples;
    bool transparent = false;
};
void addFilmOptions(CLI::App& command, FilmOptions& options);

/// Into the shot; a file of surroundings is read, so that a bad one is told at once. Throws UsageError and
/// InputFileError.
void applyPicture(const PictureOptions& options, Shot& shot);
/// The same; `look` as chosen there.
void applyFilm(const FilmOptions& options, const std::string& look, Shot& shot);

}  // namespace demolish
