// SPDX-License-Identifier: Apache-2.0
// Temporary name, write, flush, rename.
#include "app/session/output_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void failWriting(const fs::path& file, int error) {
    const char* const remedy = error == ENOENT ? "; make its folder first or choose another place"
                                               : "; choose another place or make room";
    throw OutputError("could not write " + file.string() + ": " + std::strerror(error) + remedy);
}

fs::path temporaryOf(const fs::path& file) {
    return file.string() + ".tmp";
}

/// Makes `probe` and removes it; blames `wanted`.
void tryToWrite(const fs::path& probe, const fs::path& wanted) {
    std::FILE* out = std::fopen(probe.c_str(), "wb");
    if (out == nullptr) failWriting(wanted, errno);
    std::fclose(out);
    std::error_code ignored;
    fs::remove(probe, ignored);
}

}  // namespace

void writeTextFile(const fs::path& file, const std::string& text) {
    const fs::path temporary = temporaryOf(file);
    std::FILE* out = std::fopen(temporary.c_str(), "wb");
    if (out == nullptr) failWriting(file, errno);
    const bool written =
        std::fwrite(text.data(), 1, text.size(), out) == text.size() && std::fflush(out) == 0;
    const int write_error = errno;
    const bool closed = std::fclose(out) == 0;
    std::error_code rename_error;
    if (written && closed) {
        fs::rename(temporary, file, rename_error);
        if (!rename_error) return;
    }
    const int error = !written ? write_error : !closed ? errno : rename_error.value();
    std::error_code ignored;
    fs::remove(temporary, ignored);
    failWriting(file, error);
}

void makeOutputFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) failWriting(folder, error.value());
    tryToWrite(folder / ".writable.tmp", folder);
}

void requireWritable(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) failWriting(file, EISDIR);
    tryToWrite(temporaryOf(file), file);
}

}  // namespace demolish
