// SPDX-License-Identifier: Apache-2.0
// Owning shader program made from GLSL files.
#pragma once
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <string>

#include <glm/glm.hpp>

#include "engine/gl/object.h"

namespace demolish::engine::gl {

struct ProgramTraits {
    static void destroy(GLuint id) { glDeleteProgram(id); }
};

class Program {
  public:
    Program() = default;
    /// The stage follows from the extension (.vert, .frag, .comp). `defines` are lines put after #version.
    /// Throws GlError with the file names and the compiler's message.
    Program(const std::filesystem::path& folder, std::initializer_list<std::string> files,
            const std::string& defines = "");

    void use() const { glUseProgram(object_.id()); }
    GLuint id() const { return object_.id(); }

    /// Uniforms have explicit locations in the GLSL files; these set the program's, whichever is in use.
    void set(GLint location, float value) { glProgramUniform1f(id(), location, value); }
    void set(GLint location, uint32_t value) { glProgramUniform1ui(id(), location, value); }
    void set(GLint location, int value) { glProgramUniform1i(id(), location, value); }
    void set(GLint location, glm::ivec2 v) { glProgramUniform2i(id(), location, v.x, v.y); }
    void set(GLint location, glm::ivec4 v) { glProgramUniform4i(id(), location, v.x, v.y, v.z, v.w); }
    void set(GLint location, glm::uvec2 v) { glProgramUniform2ui(id(), location, v.x, v.y); }
    void set(GLint location, glm::vec2 v) { glProgramUniform2f(id(), location, v.x, v.y); }
    void set(GLint location, glm::vec3 v) { glProgramUniform3f(id(), location, v.x, v.y, v.z); }
    void set(GLint location, glm::vec4 v) { glProgramUniform4f(id(), location, v.x, v.y, v.z, v.w); }

  private:
    Object<ProgramTraits> object_;
};

}  // namespace demolish::engine::gl
