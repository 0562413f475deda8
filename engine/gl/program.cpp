// SPDX-License-Identifier: Apache-2.0
// Compiles and links; every message names the files, since a number alone helps nobody.
#include "engine/gl/program.h"

#include <vector>

#include "engine/gl/error.h"
#include "engine/gl/shader_source.h"

namespace demolish::engine::gl {
namespace {

struct ShaderTraits {
    static void destroy(GLuint id) { glDeleteShader(id); }
};
using Shader = Object<ShaderTraits>;

GLenum stageOf(const std::string& file) {
    if (file.ends_with(".vert")) return GL_VERTEX_SHADER;
    if (file.ends_with(".frag")) return GL_FRAGMENT_SHADER;
    if (file.ends_with(".comp")) return GL_COMPUTE_SHADER;
    throw GlError("Shader file " + file + " must end in .vert, .frag or .comp.");
}

void insertDefines(std::string& text, const std::string& defines) {
    const size_t end_of_version = text.find('\n', text.find("#version"));
    text.insert(end_of_version + 1, defines);
}

Shader compile(const std::filesystem::path& folder, const std::string& file, const std::string& defines) {
    ShaderSource source = loadShaderSource(folder, file);
    if (!defines.empty()) insertDefines(source.text, defines);
    Shader shader(glCreateShader(stageOf(file)));
    const char* text = source.text.c_str();
    glShaderSource(shader.id(), 1, &text, nullptr);
    glCompileShader(shader.id());
    GLint compiled = 0;
    glGetShaderiv(shader.id(), GL_COMPILE_STATUS, &compiled);
    if (compiled != 0) return shader;
    GLint length = 0;
    glGetShaderiv(shader.id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(length), '\0');
    glGetShaderInfoLog(shader.id(), length, nullptr, log.data());
    std::string message =
        "Shader " + (folder / file).string() + " does not compile:\n" + log.c_str() + "files:";
    for (size_t i = 0; i < source.files.size(); ++i)
        message.append(" ").append(std::to_string(i)).append("=").append(source.files[i]);
    discardErrors();
    throw GlError(message);
}

}  // namespace

Program::Program(const std::filesystem::path& folder, std::initializer_list<std::string> files,
                 const std::string& defines)
    : object_(glCreateProgram()) {
    std::string names;
    std::vector<Shader> shaders;
    for (const std::string& file : files) {
        names.append(" ").append(file);
        shaders.push_back(compile(folder, file, defines));
        glAttachShader(id(), shaders.back().id());
    }
    glLinkProgram(id());
    for (const Shader& shader : shaders) glDetachShader(id(), shader.id());
    GLint linked = 0;
    glGetProgramiv(id(), GL_LINK_STATUS, &linked);
    if (linked != 0) return;
    GLint length = 0;
    glGetProgramiv(id(), GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<size_t>(length), '\0');
    glGetProgramInfoLog(id(), length, nullptr, log.data());
    discardErrors();
    throw GlError("Shaders" + names + " do not link:\n" + log.c_str());
}

}  // namespace demolish::engine::gl
