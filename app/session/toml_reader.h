// SPDX-License-Identifier: Apache-2.0
// Reads typed, ranged values out of one TOML file; every complaint names file and line.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "app/session/shot.h"

namespace demolish {

/// Paths are dotted ("impact.velocity_mps"). Throws InputFileError: unreadable, bad TOML, wrong type, out of
/// range, key, table or list that nobody asked for (a misspelt one must not be ignored).
class TomlReader {
  public:
    explicit TomlReader(const std::filesystem::path& file);
    /// This text, in place of what the file holds.
    TomlReader(const std::filesystem::path& file, const std::string& text);
    ~TomlReader();

    const std::filesystem::path& file() const;
    bool has(std::string_view path) const;
    /// Elements of a list of tables, 0 if there is none: read them as "path[0].key". Complains above `most`.
    size_t count(std::string_view path, double most) const;
    void read(std::string_view path, double& value, const Range& range);
    void read(std::string_view path, uint32_t& value, const Range& range);
    void read(std::string_view path, std::string& value);
    void read(std::string_view path, bool& value);
    void read(std::string_view path, Double3& value, const Range& range);  ///< of each of the three numbers
    void readColour(std::string_view path, float (&colour)[3]);            ///< linear, each 0..1
    void readVector(std::string_view path, glm::vec3& value, const Range& range);

    /// A complaint about one value of this file; of one that is missing the line is that of its table.
    [[noreturn]] void fail(std::string_view path, const std::string& what) const;
    /// Call at the end: complains about keys that no read() asked for.
    void requireAllRead() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The key `version`, which each file says first. Throws InputFileError where it is missing or not 1.
void requireVersion(TomlReader& reader);

}  // namespace demolish
