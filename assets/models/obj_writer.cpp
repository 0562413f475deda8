// SPDX-License-Identifier: Apache-2.0
// OBJ output.
#include "assets/models/obj_writer.h"

#include <charconv>
#include <fstream>
#include <initializer_list>
#include <stdexcept>
#include <unordered_map>

namespace demolish::sculptor {
namespace {

/// " 0.125000" and so on; a zero has no sign.
void append(std::string& text, double value, int decimals) {
    char digits[64];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
    const std::string_view number(digits, static_cast<std::size_t>(end - digits));
    const bool negative_zero =
        number.find_first_of("123456789") == std::string_view::npos && number.front() == '-';
    text += ' ';
    text += negative_zero ? number.substr(1) : number;
}

std::string line(const char* keyword, std::initializer_list<double> values, int decimals) {
    std::string text = keyword;
    for (const double value : values) append(text, value, decimals);
    return text += '\n';
}

/// Lines without repeats; the number of a line is its first place, from 1.
class Lines {
  public:
    std::size_t numberOf(const std::string& text) {
        const auto [entry, is_new] = numbers_.try_emplace(text, numbers_.size() + 1);
        if (is_new) all_ += text;
        return entry->second;
    }
    const std::string& all() const { return all_; }

  private:
    std::unordered_map<std::string, std::size_t> numbers_;
    std::string all_;
};

}  // namespace

std::string objText(const Model& model, const std::string& title) {
    const auto& [positions, triangles] = model.surface;
    std::string text = "# " + title + ": " + std::to_string(triangles.size()) + " triangles, " +
                       std::to_string(positions.size()) + " positions; metres, y up\n";
    for (const Vec3 p : positions) text += line("v", {p.x, p.y, p.z}, 6);
    Lines uv_lines, normal_lines;
    std::string faces;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        faces += 'f';
        for (int i = 0; i < 3; ++i) {
            const auto& uv = model.uvs[t][i];
            const Vec3 n = model.normals[t][i];
            faces += ' ' + std::to_string(triangles[t][i] + 1) + '/' +
                     std::to_string(uv_lines.numberOf(line("vt", {uv[0], uv[1]}, 5))) + '/' +
                     std::to_string(normal_lines.numberOf(line("vn", {n.x, n.y, n.z}, 4)));
        }
        faces += '\n';
    }
    return text + uv_lines.all() + normal_lines.all() + faces;
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    const std::filesystem::path temporary = file.string() + ".tmp";
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw std::runtime_error("cannot write " + temporary.string());
    std::filesystem::rename(temporary, file);
}

}  // namespace demolish::sculptor
