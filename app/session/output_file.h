// SPDX-License-Identifier: Apache-2.0
// Text files that are whole or not there: written under a temporary name of their own in the same folder,
// then renamed.
#pragma once
#include <exception>
#include <filesystem>
#include <functional>
#include <string>

namespace demolish {

/// What is there stays until the whole text can take its place; of several writers the last one wins. A link
/// stays one, pipes and devices are written into. Throws OutputError that names the file and the reason (no
/// such folder, no permission, disk full).
void writeTextFile(const std::filesystem::path& file, const std::string& text);
/// Files that are written after a long run: all that can be written are, then the first failure is thrown.
class LastFiles {
  public:
    /// `make` makes the text. Nothing happens where no file is named.
    void write(const std::filesystem::path& file, const std::function<std::string()>& make);
    void requireAllWritten() const;

  private:
    std::exception_ptr failure_;
};
/// Throws OutputError if the file could not be written as things are now: before hours of work, not after.
/// Leaves nothing behind, and removes what runs that were killed have left in its folder.
void requireWritable(const std::filesystem::path& file);
/// Makes the folder and its parents; throws OutputError. Also checks that a file can be made in it, and
/// removes what runs that were killed have left there.
void makeOutputFolder(const std::filesystem::path& folder);

}  // namespace demolish
