// SPDX-License-Identifier: Apache-2.0
// toml++ behind a small face.
#include "app/session/toml_reader.h"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>

#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

/// False for NaN.
bool isWithin(double number, const Range& range) {
    return number >= range.least && number <= range.most;
}

std::string textOf(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    if (in) text << in.rdbuf();
    if (!in)
        throw InputFileError(file.string() + " cannot be opened; check that it is there and may be read");
    return text.str();
}

}  // namespace

struct TomlReader::State {
    std::filesystem::path file;
    toml::table table;
    std::set<std::string> asked;             ///< paths, whether there is something or not
    std::set<const toml::node*> on_the_way;  ///< what lies on the way to them

    toml::node_view<toml::node> at(std::string_view path) {
        for (size_t end = 0; end != std::string_view::npos;) {
            end = path.find_first_of(".[", end + 1);
            const std::string_view part = path.substr(0, end);
            if (!part.ends_with(']')) asked.emplace(part);
            on_the_way.insert(table.at_path(part).node());
        }
        return table.at_path(path);
    }
    std::string place(const toml::node* node) const {
        std::string text = file.string();
        if (node != nullptr && node->source().begin)
            text.append(":").append(std::to_string(node->source().begin.line));
        return text;
    }
    /// Names the setting of the same table whose name begins most alike: a slip of the pen, or another unit.
    std::string remedy(const std::string& path) const {
        const size_t name = path.rfind('.') + 1;
        size_t alike = name + (path.size() - name - 1) / 2;
        std::string nearest;
        for (const std::string& known : asked) {
            const auto parting = std::mismatch(path.begin(), path.end(), known.begin(), known.end()).first;
            const auto begin = static_cast<size_t>(parting - path.begin());
            if (begin <= alike || known.rfind('.') + 1 != name) continue;
            alike = begin;
            nearest = known;
        }
        return nearest.empty() ? "remove it or mend its name" : "is '" + nearest + "' meant?";
    }
    [[noreturn]] void refuse(const toml::node& node, const std::string& path) const {
        const bool is_quoted = path.ends_with('"');
        throw InputFileError(place(&node) + ": there is no setting '" + path + "'; " +
                             (is_quoted ? "write it without quotes, or remove it" : remedy(path)));
    }
    /// Goes by nodes, not by names: a key in quotes may hold dots and brackets itself.
    void requireKnown(const toml::table& level, const std::string& prefix) const {
        for (const auto& [key, node] : level) {
            const std::string name(key.str());
            const bool is_bare = name.find_first_of(".[") == std::string::npos;
            const std::string path = prefix + (is_bare ? name : '"' + name + '"');
            if (on_the_way.count(&node) == 0) refuse(node, path);
            if (const auto* below = node.as_table()) requireKnown(*below, path + ".");
            const auto* list = node.as_array();
            for (size_t i = 0; list != nullptr && i < list->size(); ++i)
                if (const auto* element = list->get(i)->as_table())
                    requireKnown(*element, path + "[" + std::to_string(i) + "].");
        }
    }
};

TomlReader::TomlReader(const std::filesystem::path& file) : TomlReader(file, textOf(file)) {}

TomlReader::TomlReader(const std::filesystem::path& file, const std::string& text)
    : state_(std::make_unique<State>()) {
    state_->file = file;
    try {
        state_->table = toml::parse(text, file.string());
    } catch (const toml::parse_error& error) {
        std::ostringstream complaint;
        complaint << file.string();
        if (error.source().begin) complaint << ":" << error.source().begin.line;
        complaint << ": " << error.description();
        throw InputFileError(complaint.str());
    }
}

TomlReader::~TomlReader() = default;

const std::filesystem::path& TomlReader::file() const {
    return state_->file;
}

bool TomlReader::has(std::string_view path) const {
    state_->asked.emplace(path);
    return static_cast<bool>(state_->table.at_path(path));
}

size_t TomlReader::count(std::string_view path, double most) const {
    const auto node = state_->at(path);
    if (!node) return 0;
    const auto* list = node.as_array();
    if (list == nullptr || (!list->empty() && !list->is_homogeneous<toml::table>()))
        fail(path, "must be a list of tables");
    if (static_cast<double>(list->size()) > most) {
        fail(path, "has " + std::to_string(list->size()) + " entries; at most " + plainNumber(most) +
                       " are possible");
    }
    return list->size();
}

void TomlReader::fail(std::string_view path, const std::string& what) const {
    std::string_view at = path;
    while (!at.empty() && !state_->table.at_path(at)) {
        const size_t dot = at.rfind('.');
        at = at.substr(0, dot == std::string_view::npos ? 0 : dot);
    }
    const toml::node* node = at.empty() ? nullptr : state_->table.at_path(at).node();
    throw InputFileError(state_->place(node) + ": " + std::string(path) + " " + what);
}

void TomlReader::read(std::string_view path, double& value, const Range& range) {
    const auto node = state_->at(path);
    if (!node) return;
    const auto number = node.value<double>();
    if (!number || !isWithin(*number, range))
        fail(path, range.least == range.most ? "must be " + plainNumber(range.least)
                                             : "must be a number between " + plainNumber(range.least) +
                                                   " and " + plainNumber(range.most));
    value = *number;
}

void TomlReader::read(std::string_view path, uint32_t& value, const Range& range) {
    double number = value;
    read(path, number, range);
    if (number != std::floor(number)) fail(path, "must be a whole number");
    value = static_cast<uint32_t>(number);
}

void TomlReader::read(std::string_view path, std::string& value) {
    const auto node = state_->at(path);
    if (!node) return;
    const auto text = node.value<std::string>();
    if (!text) fail(path, "must be a text in quotes");
    value = *text;
}

void TomlReader::read(std::string_view path, bool& value) {
    const auto node = state_->at(path);
    if (!node) return;
    const auto truth = node.value_exact<bool>();
    if (!truth) fail(path, "must be true or false");
    value = *truth;
}

void TomlReader::read(std::string_view path, Double3& value, const Range& range) {
    const auto node = state_->at(path);
    if (!node) return;
    const std::string wanted =
        "must be three numbers between " + plainNumber(range.least) + " and " + plainNumber(range.most);
    const auto* list = node.as_array();
    if (list == nullptr || list->size() != 3) fail(path, wanted);
    double* const parts[3] = {&value.x, &value.y, &value.z};
    for (size_t i = 0; i < 3; ++i) {
        const auto number = list->get(i)->value<double>();
        if (!number || !isWithin(*number, range)) fail(path, wanted);
        *parts[i] = *number;
    }
}

void TomlReader::readVector(std::string_view path, glm::vec3& value, const Range& range) {
    Double3 numbers{value.x, value.y, value.z};
    read(path, numbers, range);
    value = glm::vec3(numbers.x, numbers.y, numbers.z);
}

void TomlReader::readColour(std::string_view path, float (&colour)[3]) {
    Double3 numbers{colour[0], colour[1], colour[2]};
    read(path, numbers, {0, 1});
    colour[0] = static_cast<float>(numbers.x);
    colour[1] = static_cast<float>(numbers.y);
    colour[2] = static_cast<float>(numbers.z);
}

void TomlReader::requireAllRead() const {
    state_->requireKnown(state_->table, "");
}

void requireVersion(TomlReader& reader) {
    constexpr double kVersion = 1;
    uint32_t version = 0;
    if (!reader.has("version")) reader.fail("version", "is missing; write version = 1");
    reader.read("version", version, {kVersion, kVersion});
}

}  // namespace demolish
