// SPDX-License-Identifier: Apache-2.0
// GLSL files with #include "path", path counted from the shader folder.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace demolish::engine::gl {

struct ShaderSource {
    std::string text;
    std::vector<std::string> files;  ///< index = GLSL's source string number in #line
};

/// Reads `file` under `folder` and everything it includes; the compiler sees each file once, where it is
/// first included in a part that is not skipped. Throws GlError when one is missing.
ShaderSource loadShaderSource(const std::filesystem::path& folder, const std::string& file);

}  // namespace demolish::engine::gl
