// SPDX-License-Identifier: Apache-2.0
// Every grain is asked whether it glows: there are few sparks, and they are born among the grains.
#include "engine/passes/spark_pass.h"

#include <string>

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kPixels = 1;
constexpr GLuint kSolidUnit = 4;

}  // namespace

std::string solidDefines(const RenderTargets& targets, bool full, bool with_colliders) {
    return "#define SAMPLES " + std::to_string(targets.samples) + (full ? "\n#define FULL\n" : "\n") +
           (with_colliders ? "#define COLLIDERS\n" : "");
}

void SparkPass::draw(const FractureMesh& mesh, const RenderTargets& targets, const gl::Texture* nearest_depth,
                     GLuint framebuffer) {
    const bool full = nearest_depth != nullptr;
    gl::Program& program = programs_[{targets.samples, full, with_colliders_}];
    if (program.id() == 0)
        program =
            gl::Program(shaders_, {"spark.vert", "spark.frag"}, solidDefines(targets, full, with_colliders_));
    program.set(kPixels, 1.0f);
    (full ? *nearest_depth : targets.depth).bind(kSolidUnit);
    bindStorage(StorageBinding::kParticles, mesh.stream(StreamId::kGrains));
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width, targets.height);
    program.use();
    no_attributes_.bind();
    mesh.drawEffect(kSparkCommand, GL_TRIANGLE_STRIP);
    glDisable(GL_BLEND);
}

}  // namespace demolish::engine
