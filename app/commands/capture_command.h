// SPDX-License-Identifier: Apache-2.0
// demolish capture: breaks a model without a window and writes pictures, a film and a report.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/commands/run_files.h"
#include "app/commands/shot_options.h"

namespace demolish {

struct CaptureOptions {
    ShotOptions shot;
    FilmOptions film;
    double frames = 150;
    std::vector<double> at;             ///< s: draws these moments only; empty: `frames` frames
    std::vector<double> camera_yaw{0};  ///< degrees, from the shot's camera about its target; one a camera
    double camera_pitch = 0;            ///< degrees, of all cameras
    std::string out, video, view = "surface";
    RunFiles files{RunCommand::kCapture};
};

void addCaptureCommand(CLI::App& app, CaptureOptions& options);

}  // namespace demolish
