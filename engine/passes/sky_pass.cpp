// Drawn last at the far end of the depth, so that covered pixels cost nothing.
#include "engine/passes/sky_pass.h"

namespace demolish::engine {

SkyPass::SkyPass(const std::filesystem::path& shaders) : program_(shaders, {"fullscreen.vert", "sky.frag"}) {}

void SkyPass::draw() const {
    program_.use();
    no_attributes_.bind();
    glDepthMask(GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthMask(GL_TRUE);
}

}  // namespace demolish::engine
