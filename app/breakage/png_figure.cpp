// SPDX-License-Identifier: Apache-2.0
// rsvg-convert as a child process that writes a file of its own, which is then renamed.
#include "app/breakage/png_figure.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>
#include <vector>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

constexpr const char* kProgram = "rsvg-convert";

/// 0, or the error number with which it did not start.
int start(std::vector<std::string> words, pid_t& child) {
    std::vector<char*> pointers;
    for (std::string& word : words) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    return posix_spawnp(&child, kProgram, nullptr, nullptr, pointers.data(), environ);
}

bool endedWell(pid_t child) {
    int status = 0;
    while (waitpid(child, &status, 0) < 0)
        if (errno != EINTR) return false;
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

bool drawAsPng(const fs::path& svg) {
    fs::path png = svg;
    png.replace_extension(".png");
    const fs::path unfinished = png.string() + "." + std::to_string(getpid());
    pid_t child = 0;
    const int error = start({kProgram, "--zoom=2", "--output=" + unfinished.string(), svg.string()}, child);
    if (error == ENOENT) return false;
    std::error_code failure;
    std::string why;
    if (error != 0)
        why = std::strerror(error);
    else if (!endedWell(child))
        why = "rsvg-convert failed; is there room on the disk?";
    else if (fs::rename(unfinished, png, failure); failure)
        why = failure.message();
    if (why.empty()) return true;
    fs::remove(unfinished, failure);
    throw OutputError("could not write the figure " + png.string() + ": " + why);
}

}  // namespace demolish
