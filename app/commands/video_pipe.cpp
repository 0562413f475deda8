// SPDX-License-Identifier: Apache-2.0
// ffmpeg as a child process that reads raw frames from a pipe.
#include "app/commands/video_pipe.h"

#include <string>
#include <system_error>
#include <vector>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kAskFfmpeg =
    "ffmpeg gave up (its message is above); does the name end with .mp4, .mkv or .mov, is there room on the "
    "disk?";

[[noreturn]] void failVideo(const std::filesystem::path& file, const std::string& why) {
    throw OutputError("could not write the video " + file.string() + ": " + why);
}

std::vector<std::string> arguments(const std::filesystem::path& file, int width, int height, double fps) {
    const std::string size = std::to_string(width) + "x" + std::to_string(height);
    // H.264 in 4:2:0 wants even sides; the picture is BT.709. Without -xerror ffmpeg ends with 0 after a film
    // that the disk had no room for.
    return {"ffmpeg",
            "-y",
            "-loglevel",
            "error",
            "-xerror",
            "-f",
            "rawvideo",
            "-pix_fmt",
            "rgba",
            "-s",
            size,
            "-r",
            std::to_string(fps),
            "-i",
            "-",
            "-an",
            "-vf",
            "scale=trunc(iw/2)*2:trunc(ih/2)*2:out_color_matrix=bt709,format=yuv420p",
            "-colorspace",
            "bt709",
            "-color_primaries",
            "bt709",
            "-color_trc",
            "bt709",
            "-c:v",
            "libx264",
            "-preset",
            "veryfast",
            "-crf",
            "18",
            "-movflags",
            "+faststart",
            "file:" + file.string()};  // else "take:1.mp4" is a protocol and "-x.mp4" an option
}

}  // namespace

VideoPipe::VideoPipe(const std::filesystem::path& file, int width, int height, double fps) : file_(file) {
    try {
        film_.emplace(file.has_parent_path() ? file.parent_path() : ".", file.extension().string());
        // A group of its own: Ctrl-C is for us, and ffmpeg ends when its input does.
        ffmpeg_.emplace(ChildPlan{.words = arguments(film_->path(), width, height, fps),
                                  .input = ChildStream::kPiped,
                                  .own_group = true});
    } catch (const std::system_error& error) {
        failVideo(file, error.code().message() + "; choose another place");
    } catch (const ChildError& error) {
        failVideo(file, error.is_missing
                            ? "the ffmpeg program is missing; install the package ffmpeg or leave --video out"
                            : std::string("ffmpeg did not start: ") + error.what());
    }
}

void VideoPipe::write(std::span<const uint8_t> pixels) {
    if (!ffmpeg_->write(pixels)) failVideo(file_, kAskFfmpeg);
}

void VideoPipe::finish() {
    const bool made = ffmpeg_->wait().well();
    ffmpeg_.reset();
    if (!made) failVideo(file_, kAskFfmpeg);
    try {
        film_->moveTo(file_);
    } catch (const std::system_error& error) {
        failVideo(file_, error.code().message());
    }
}

}  // namespace demolish
