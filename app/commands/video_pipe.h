// SPDX-License-Identifier: Apache-2.0
// Raw frames to the ffmpeg program. Its file appears under its name only when it is whole.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "app/process/child_process.h"
#include "engine/image/unfinished_file.h"

namespace demolish {

class VideoPipe {
  public:
    /// H.264 in what the ending says (MP4, MOV, Matroska, AVI), `fps` frames a second. Throws OutputError for
    /// another ending, when there is no ffmpeg or the folder cannot be written.
    VideoPipe(const std::filesystem::path& file, int width, int height, double fps);

    /// RGBA8, rows from the top. Throws OutputError when ffmpeg has given up.
    void write(std::span<const uint8_t> pixels);
    /// Ends the film and gives it its name. Throws OutputError.
    void finish();

  private:
    std::filesystem::path file_;
    std::optional<engine::UnfinishedFile> film_;
    std::optional<ChildProcess> ffmpeg_;  ///< none when the film is done; ends before its file does
};

}  // namespace demolish
