// SPDX-License-Identifier: Apache-2.0
// A strip of two triangles; seen from below it is not there, so that a camera under the floor still sees the
// body.
#include "engine/passes/floor_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kId = 0;

}  // namespace

FloorPass::FloorPass(const std::filesystem::path& shaders)
    : ids_(shaders, {"floor.vert", "id.frag"}, "#define CONSTANT_ID\n") {
    glProgramUniform1ui(ids_.id(), kId, kFloorId);
}

void FloorPass::drawIds() {
    ids_.use();
    no_attributes_.bind();
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

}  // namespace demolish::engine
