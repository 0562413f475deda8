// SPDX-License-Identifier: Apache-2.0
// Temporary file of its own, write, flush, rename.
#include "app/session/output_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

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

/// A new file in one folder, which nobody else has opened or named; gone with this, unless moved.
class TemporaryFile {
  public:
    /// `wanted` is blamed for what goes wrong.
    TemporaryFile(const fs::path& folder, const fs::path& wanted) {
        static std::atomic<unsigned> count = 0;
        do {
            path_ = folder / (".demolish." + std::to_string(getpid()) + "." + std::to_string(count++));
            stream_.reset(std::fopen(path_.c_str(), "wbx"));
        } while (!stream_ && errno == EEXIST);
        if (!stream_) failWriting(wanted, errno);
    }
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    std::unique_ptr<std::FILE, CloseFile>& stream() { return stream_; }
    /// Replaces `target` in one step.
    void moveTo(const fs::path& target, const fs::path& wanted) {
        if (std::rename(path_.c_str(), target.c_str()) != 0) failWriting(wanted, errno);
        path_.clear();
    }

  private:
    fs::path path_;
    std::unique_ptr<std::FILE, CloseFile> stream_;
};

/// Closes the stream: the last blocks may reach the disk, or fail to, only then.
void writeAll(std::unique_ptr<std::FILE, CloseFile>& stream, const std::string& text,
              const fs::path& wanted) {
    errno = 0;
    const bool written = std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
                         std::fflush(stream.get()) == 0;
    const int error = errno;
    if (!written) failWriting(wanted, error);
    if (std::fclose(stream.release()) != 0) failWriting(wanted, errno);
}

/// Opens a pipe or device; what has no reader blocks until it has one.
std::unique_ptr<std::FILE, CloseFile> openSink(const fs::path& file) {
    std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "wb"));
    if (!stream) failWriting(file, errno);
    return stream;
}

fs::path folderOf(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

}  // namespace

void writeTextFile(const fs::path& file, const std::string& text) {
    if (isSink(file)) {
        auto stream = openSink(file);
        return writeAll(stream, text, file);
    }
    const fs::path target = targetOf(file);
    TemporaryFile temporary(folderOf(target), file);
    writeAll(temporary.stream(), text, file);
    temporary.moveTo(target, file);
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
    const TemporaryFile probe(folder, folder);
}

void requireWritable(const fs::path& file) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) failWriting(file, EISDIR);
    if (isSink(file)) {
        if (access(file.c_str(), W_OK) != 0) failWriting(file, errno);
        return;
    }
    const TemporaryFile probe(folderOf(targetOf(file)), file);
}

}  // namespace demolish
