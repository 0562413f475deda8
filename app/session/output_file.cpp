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
    throw OutputError("could not write " + file.string() + ": " + std::strerror(error) +
                      "; choose another place or make room");
}

}  // namespace

void writeTextFile(const fs::path& file, const std::string& text) {
    const fs::path temporary = file.string() + ".tmp";
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
    const fs::path probe = folder / ".writable.tmp";
    std::FILE* out = std::fopen(probe.c_str(), "wb");
    if (out == nullptr) failWriting(folder, errno);
    std::fclose(out);
    fs::remove(probe, error);
}

}  // namespace demolish
