// SPDX-License-Identifier: Apache-2.0
// A file in the making: under a name of its own beside the place where it will stand, until it is whole.
#pragma once
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

namespace demolish::engine {

/// Its name, ".demolish.PROCESS.NUMBER" and an ending, says that it is ours; a lock, which ends with the
/// process however that ends, says that it is still being made.
class UnfinishedFile {
  public:
    /// A new, empty file in the folder. `ending`: of its name, for programs that go by it (".mp4"). Throws
    /// std::system_error.
    explicit UnfinishedFile(const std::filesystem::path& folder, const std::string& ending = "");
    /// Removes it, unless it was moved.
    ~UnfinishedFile();
    UnfinishedFile(const UnfinishedFile&) = delete;
    UnfinishedFile& operator=(const UnfinishedFile&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// To write it; null when it is closed.
    std::FILE* stream() { return stream_.get(); }
    /// The last blocks may reach the disk, or fail to, only now. Throws std::system_error.
    void close();
    /// Replaces `target` in one step. Throws std::system_error.
    void moveTo(const std::filesystem::path& target);

  private:
    struct CloseFile {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    bool take(const std::filesystem::path& path);

    std::filesystem::path path_;
    std::unique_ptr<std::FILE, CloseFile> stream_;
    int lock_ = -1;  ///< held until the file is moved or removed
};

/// Removes what runs that ended amid their work have left in the folder: files of such names whose lock
/// nobody holds. What cannot be locked or removed stays.
void removeAbandonedFiles(const std::filesystem::path& folder);

}  // namespace demolish::engine
