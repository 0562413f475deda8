// SPDX-License-Identifier: Apache-2.0
// Every grain is asked whether it glows: there are few sparks, and they are born among the grains.
#include "engine/passes/spark_pass.h"

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kPixels = 1, kOpening = 2;
constexpr GLuint kSolidUnit = 4;

}  // namespace

void SparkPass::draw(const FractureMesh& mesh, const RenderTargets& targets, const gl::Texture* nearest_depth,
                     GLuint framebuffer) {
    const bool full = nearest_depth != nullptr;
    PictureKind kind = kind_;
    kind.samples = targets.samples;
    gl::Program& program = programs_[{full, kind}];
    if (program.id() == 0) {
        program = gl::Program(shaders_, {"spark.vert", "spark.frag"},
                              defines(kind) + (full ? "#define FULL\n" : ""));
        setTone(program, kind.tone);
    }
    program.set(kPixels, 1.0f);
    program.set(kOpening, glm::vec4(opening_.seconds, opening_.shares));
    (full ? *nearest_depth : targets.depth).bind(kSolidUnit);
    bindStorage(StorageBinding::kParticles, mesh.stream(StreamId::kGrains));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    // Light adds up. What is mapped to the display already cannot, and takes what is left to white.
    glBlendFuncSeparate(GL_ONE, kind.radiance ? GL_ONE : GL_ONE_MINUS_SRC_COLOR, GL_ONE,
                        GL_ONE_MINUS_SRC_ALPHA);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width, targets.height);
    program.use();
    no_attributes_.bind();
    mesh.drawEffect(kSparkCommand, GL_TRIANGLE_STRIP);
    glDisable(GL_BLEND);
}

}  // namespace demolish::engine
