// SPDX-License-Identifier: Apache-2.0
// Temporary file of its own, write, flush, rename.
#include "app/session/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "engine/image/unfinished_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void failWriting(const fs::path& file, int error) {
    const char* const remedy = error == ENOENT ? "; make its folder first or choose another place"
                                               : "; choose another place or make room";
    throw OutputError("could not write " + file.string() + ": " + std::strerror(error) + remedy);
}

/// Where the bytes go: a link stays one.
fs::path targetOf(const fs::path& file) {
    std::error_code error;
    fs::path target = fs::is_symlink(file, error) ? fs::weakly_canonical(file, error) : file;
    return error ? file : target;
}

/// A pipe or a device: nothing can be renamed to it.
bool isSink(const fs::path& file) {
    std::error_code ignored;
    const auto status = fs::status(file, ignored);
    return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};

void writeAll(std::FILE* stream, const std::string& text, const fs::path& wanted) {
    errno = 0;
    if (std::fwrite(text.data(), 1, text.size(), stream) != text.size() || std::fflush(stream) != 0)
        failWriting(wanted, errno);
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

/// What is made on the way to `wanted`, which is blamed for what goes wrong.
template <class Make>
void making(const fs::path& wanted, const Make& make) {
    try {
        make();
    } catch (const std::system_error& error) {
        failWriting(wanted, error.code().value());
    }
}

/// A file can be made in the folder.
void tryOut(const fs::path& folder, const fs::path& wanted) {
    engine::removeAbandonedFiles(folder);
    making(wanted, [&] { const engine::UnfinishedFile probe(folder); });
}

/// Waits for a pipe's reader.
void writeIntoSink(const fs::path& sink, const std::string& text) {
    const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(sink.c_str(), "wb"));
    if (!stream) failWriting(sink, errno);
    writeAll(stream.get(), text, sink);
}

}  // namespace

void writeTextFile(const fs::path& file, const std::string& text) {
    if (isSink(file)) return writeIntoSink(file, text);
    const fs::path target = targetOf(file);
    making(file, [&] {
        engine::UnfinishedFile unfinished(folderOf(target));
        writeAll(unfinished.stream(), text, file);
        unfinished.close();
        unfinished.moveTo(target);
    });
}

void LastFiles::write(const fs::path& file, const std::function<std::string()>& make) {
    if (file.empty()) return;
    try {
        writeTextFile(file, make());
    } catch (...) {
        if (!failure_) failure_ = std::current_exception();
    }
}

void LastFiles::requireAllWritten() const {
    if (failure_) std::rethrow_exception(failure_);
}

void makeOutputFolder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) failWriting(folder, error.value());
    tryOut(folder, folder);
}

void requireWritable(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) failWriting(file, EISDIR);
    if (isSink(file)) {
        if (access(file.c_str(), W_OK) != 0) failWriting(file, errno);
        return;
    }
    tryOut(folderOf(targetOf(file)), file);
}

}  // namespace demolish
