// SPDX-License-Identifier: Apache-2.0
// Line numbers survive inclusion, so that a compiler message points at the file that people edit.
#include "engine/gl/shader_source.h"

#include <algorithm>
#include <fstream>

#include "engine/gl/error.h"

namespace demolish::engine::gl {
namespace {

void append(ShaderSource& source, const std::filesystem::path& folder, const std::string& file) {
    std::ifstream stream(folder / file);
    if (!stream) {
        throw GlError("Cannot read the shader " + (folder / file).string() +
                      "; Demolish's folder 'shaders' belongs there, whole.");
    }
    const std::string number = std::to_string(source.files.size());
    source.files.push_back(file);
    int line_number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++line_number;
        const size_t quote = line.rfind("#include \"", 0) == 0 ? line.find('"') : std::string::npos;
        if (quote == std::string::npos) {
            source.text += line + '\n';
            // GLSL wants #version first; number the lines after it.
            if (line.rfind("#version", 0) == 0)
                source.text += "#line " + std::to_string(line_number + 1) + ' ' + number + '\n';
            continue;
        }
        const std::string included = line.substr(quote + 1, line.rfind('"') - quote - 1);
        if (std::find(source.files.begin(), source.files.end(), included) == source.files.end()) {
            source.text += "#line 1 " + std::to_string(source.files.size()) + '\n';
            append(source, folder, included);
        }
        source.text += "#line " + std::to_string(line_number + 1) + ' ' + number + '\n';
    }
}

}  // namespace

ShaderSource loadShaderSource(const std::filesystem::path& folder, const std::string& file) {
    ShaderSource source;
    append(source, folder, file);
    return source;
}

}  // namespace demolish::engine::gl
