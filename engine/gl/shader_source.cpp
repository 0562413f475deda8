// SPDX-License-Identifier: Apache-2.0
// Line numbers survive inclusion, so that a compiler message points at the file that people edit.
#include "engine/gl/shader_source.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "engine/gl/error.h"

namespace demolish::engine::gl {
namespace {

/// Number of the file in #line; a new one for a file not seen before.
std::string numberOf(ShaderSource& source, const std::string& file) {
    const auto found = std::find(source.files.begin(), source.files.end(), file);
    const auto number = found - source.files.begin();
    if (found == source.files.end()) source.files.push_back(file);
    return std::to_string(number);
}

/// Puts files where they are included. Whether that is in a part that the compiler skips only the compiler
/// knows, so what is included again is pasted again, unless it surely stands above; a guard keeps one.
class Pasting {
  public:
    Pasting(ShaderSource& source, const std::filesystem::path& folder) : source_(source), folder_(folder) {}

    void paste(const std::string& file) {
        std::ifstream stream(folder_ / file);
        if (!stream) {
            throw GlError("Cannot read the shader " + (folder_ / file).string() +
                          "; Demolish's folder 'shaders' belongs there, whole.");
        }
        const std::string number = numberOf(source_, file);
        int line_number = 0;
        for (std::string line; std::getline(stream, line);) {
            ++line_number;
            const auto goOnBelow = [&] {
                source_.text += "#line " + std::to_string(line_number + 1) + ' ' + number + '\n';
            };
            if (line.starts_with("#include \"")) {
                const size_t quote = line.find('"') + 1;
                include(line.substr(quote, line.rfind('"') - quote));
                goOnBelow();
                continue;
            }
            source_.text += line + '\n';
            if (line.starts_with("#version")) goOnBelow();  // GLSL wants it first
            if (line.starts_with("#if")) ++depth_;
            if (line.starts_with("#endif")) --depth_;
        }
    }

  private:
    void include(const std::string& file) {
        const auto isIn = [&](const std::vector<std::string>& list) {
            return std::find(list.begin(), list.end(), file) != list.end();
        };
        if (isIn(above_) || isIn(open_)) return;
        if (depth_ == 0) above_.push_back(file);
        open_.push_back(file);
        std::string guard = "PASTED_" + file;
        for (char& c : guard)
            if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
        source_.text +=
            "#ifndef " + guard + "\n#define " + guard + "\n#line 1 " + numberOf(source_, file) + '\n';
        paste(file);
        source_.text += "#endif\n";
        open_.pop_back();
    }

    ShaderSource& source_;
    const std::filesystem::path& folder_;
    std::vector<std::string> above_;  ///< pasted outside of every condition
    std::vector<std::string> open_;   ///< that are being pasted
    int depth_ = 0;                   ///< conditions open at this place, guards not counted
};

}  // namespace

ShaderSource loadShaderSource(const std::filesystem::path& folder, const std::string& file) {
    ShaderSource source;
    Pasting(source, folder).paste(file);
    return source;
}

}  // namespace demolish::engine::gl
