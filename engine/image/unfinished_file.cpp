// SPDX-License-Identifier: Apache-2.0
// A lock of flock() belongs to the open file, not to the process: threads of one program keep clear of each
// other's files, and so do machines that share a folder.
#include "engine/image/unfinished_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cerrno>
#include <string_view>
#include <system_error>

namespace demolish::engine {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kMark = ".demolish.";

[[noreturn]] void fail() {
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category());
}

bool isNumber(std::string_view text) {
    return !text.empty() &&
           std::all_of(text.begin(), text.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// ".demolish.123.4" or ".demolish.123.4.mp4".
bool isOurs(const fs::path& file) {
    const std::string name = file.filename().string();
    if (!name.starts_with(kMark)) return false;
    const std::string_view rest = std::string_view(name).substr(kMark.size());
    const size_t dot = rest.find('.');
    if (dot == std::string_view::npos) return false;
    const std::string_view number = rest.substr(dot + 1);
    return isNumber(rest.substr(0, dot)) && isNumber(number.substr(0, number.find('.')));
}

/// Does the path still lead to this open file?
bool leadsTo(const fs::path& path, int file) {
    struct stat there = {}, here = {};
    return stat(path.c_str(), &there) == 0 && fstat(file, &here) == 0 && there.st_dev == here.st_dev &&
           there.st_ino == here.st_ino;
}

}  // namespace

/// False where somebody else has this name, or has swept the file away before it was locked.
bool UnfinishedFile::take(const fs::path& path) {
    errno = 0;
    lock_ = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (lock_ < 0 && errno == EEXIST) return false;
    if (lock_ < 0) fail();
    // A file system that knows no locks lets nobody sweep, either.
    const bool locked = flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (locked && leadsTo(path, lock_)) return true;
    ::close(lock_);
    return false;
}

UnfinishedFile::UnfinishedFile(const fs::path& folder, const std::string& ending) {
    static std::atomic<unsigned> count = 0;
    do {
        path_ =
            folder / (std::string(kMark) + std::to_string(getpid()) + "." + std::to_string(count++) + ending);
    } while (!take(path_));
    const int copy = fcntl(lock_, F_DUPFD_CLOEXEC, 0);
    if (copy >= 0) stream_.reset(fdopen(copy, "wb"));
    if (stream_) return;
    const int error = errno;
    unlink(path_.c_str());
    ::close(lock_);
    errno = error;
    fail();
}

UnfinishedFile::~UnfinishedFile() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove(path_, ignored);
    ::close(lock_);
}

void UnfinishedFile::close() {
    errno = 0;
    if (stream_ && std::fclose(stream_.release()) != 0) fail();
}

void UnfinishedFile::moveTo(const fs::path& target) {
    errno = 0;
    if (std::rename(path_.c_str(), target.c_str()) != 0) fail();
    path_.clear();
}

void removeAbandonedFiles(const fs::path& folder) {
    std::error_code ignored;
    for (fs::directory_iterator at(folder, ignored), end; at != end; at.increment(ignored)) {
        const fs::path path = at->path();
        if (!isOurs(path) || at->symlink_status(ignored).type() != fs::file_type::regular) continue;
        const int file = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
        if (file < 0) continue;
        if (flock(file, LOCK_EX | LOCK_NB) == 0) fs::remove(path, ignored);
        ::close(file);
    }
}

}  // namespace demolish::engine
