// SPDX-License-Identifier: Apache-2.0
// ffmpeg as a child process that reads raw frames from a pipe.
#include "app/commands/video_pipe.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr const char* kAskFfmpeg = "ffmpeg gave up (its message is above); is there room on the disk?";

struct Container {
    std::string_view ending;
    const char* muxer;
};
/// That hold H.264.
constexpr std::array<Container, 5> kContainers = {
    {{".mp4", "mp4"}, {".m4v", "mp4"}, {".mov", "mov"}, {".mkv", "matroska"}, {".avi", "avi"}}};

[[noreturn]] void failVideo(const std::filesystem::path& file, const std::string& why) {
    throw OutputError("could not write the video " + file.string() + ": " + why);
}

const char* muxerFor(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto known = std::find_if(kContainers.begin(), kContainers.end(),
                                    [&](const auto& c) { return c.ending == ending; });
    if (known == kContainers.end()) failVideo(file, "a film's name ends with .mp4, .m4v, .mov, .mkv or .avi");
    return known->muxer;
}

/// Closed when the child has it.
class OpenFilm {
  public:
    explicit OpenFilm(const std::filesystem::path& path) : file_(open(path.c_str(), O_RDWR | O_CLOEXEC)) {
        if (file_ < 0) throw std::system_error(errno, std::generic_category());
    }
    ~OpenFilm() { close(file_); }
    OpenFilm(const OpenFilm&) = delete;
    OpenFilm& operator=(const OpenFilm&) = delete;
    int descriptor() const { return file_; }

  private:
    int file_;
};

std::vector<std::string> arguments(const char* muxer, int width, int height, double fps) {
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
            "-f",
            muxer,
            std::string("file:") + kSharedFile};
}

}  // namespace

/// ffmpeg gets an open file, not a name: when this program is killed it may run on for a moment, and would
/// make the file anew that the next run has swept away.
VideoPipe::VideoPipe(const std::filesystem::path& file, int width, int height, double fps) : file_(file) {
    const char* muxer = muxerFor(file);
    try {
        film_.emplace(file.has_parent_path() ? file.parent_path() : ".", file.extension().string());
        // A group of its own: Ctrl-C is for us, and ffmpeg ends when its input does.
        const OpenFilm shared(film_->path());
        ffmpeg_.emplace(ChildPlan{.words = arguments(muxer, width, height, fps),
                                  .input = ChildStream::kPiped,
                                  .own_group = true,
                                  .shares = shared.descriptor()});
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
