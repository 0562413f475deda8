// SPDX-License-Identifier: Apache-2.0
// ffmpeg as a child process that reads raw frames from a pipe.
#include "app/commands/video_pipe.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include "sim_cuda/api/errors.h"

extern char** environ;

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
            file.string()};
}

}  // namespace

VideoPipe::VideoPipe(const std::filesystem::path& file, int width, int height, double fps)
    : file_(file),
      temporary_(file.parent_path() / (file.stem().string() + ".unfinished" + file.extension().string())) {
    if (std::FILE* probe = std::fopen(temporary_.c_str(), "wb"))
        std::fclose(probe);
    else
        failVideo(file, std::string(std::strerror(errno)) + "; choose another place");
    std::signal(SIGPIPE, SIG_IGN);  // a dead ffmpeg must become an error, not the end of the program
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) failVideo(file, std::strerror(errno));

    std::vector<std::string> words = arguments(temporary_, width, height, fps);
    std::vector<char*> pointers;
    for (auto& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    // A group of its own: Ctrl-C is for us, and ffmpeg ends when the pipe does.
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawnp(&process_, "ffmpeg", &actions, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[0]);
    pipe_ = ends[1];
    if (error == 0) return;
    close(pipe_);
    std::filesystem::remove(temporary_);
    failVideo(file, error == ENOENT
                        ? "the ffmpeg program is missing; install the package ffmpeg or leave --video out"
                        : std::string("ffmpeg did not start: ") + std::strerror(error));
}

VideoPipe::~VideoPipe() {
    if (pipe_ >= 0) close(pipe_);
    if (process_ > 0) {
        waitpid(process_, nullptr, 0);
        std::error_code ignored;
        std::filesystem::remove(temporary_, ignored);
    }
}

void VideoPipe::write(std::span<const uint8_t> pixels) {
    while (!pixels.empty()) {
        const ssize_t written = ::write(pipe_, pixels.data(), pixels.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) failVideo(file_, kAskFfmpeg);
        pixels = pixels.subspan(static_cast<size_t>(written));
    }
}

void VideoPipe::finish() {
    close(pipe_);
    pipe_ = -1;
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    std::error_code error;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) {
        std::filesystem::rename(temporary_, file_, error);
        if (!error) return;
    }
    const std::string why = error ? error.message() : kAskFfmpeg;
    std::filesystem::remove(temporary_, error);
    failVideo(file_, why);
}

}  // namespace demolish
