// SPDX-License-Identifier: Apache-2.0
// Sparks are born among the grains, and few: those that glow are listed first.
#include "engine/passes/spark_pass.h"

#include "engine/passes/body_geometry.h"

namespace demolish::engine {
namespace {

constexpr GLint kPixels = 1, kOpening = 2;
constexpr GLuint kSolidUnit = 4;
/// Grains that one command draws; as shaders/spark_list.comp.
constexpr size_t kGroup = 2048;
constexpr size_t kGrainBytes = 32;

}  // namespace

SparkPass::SparkPass(const std::filesystem::path& shaders)
    : shaders_(shaders), list_(shaders, {"spark_list.comp"}) {
    layout_.integerAttribute(0, 1, GL_UNSIGNED_INT, 0);
    layout_.advanceByInstance();
}

GLsizei SparkPass::list(const FractureMesh& mesh) {
    const gl::Buffer& grains = mesh.stream(StreamId::kGrains);
    const size_t groups = (grains.size() / kGrainBytes + kGroup - 1) / kGroup;
    if (commands_.size() != groups * kEffectCommandBytes) {
        commands_ = gl::Buffer::immutable(groups * kEffectCommandBytes);
        ids_ = gl::Buffer::immutable(groups * kGroup * sizeof(GLuint));
        layout_.setVertices(ids_, sizeof(GLuint));
    }
    bindStorage(StorageBinding::kParticles, grains);
    bindStorage(StorageBinding::kEffectCommands, mesh.stream(StreamId::kEffectCommands));
    bindStorage(StorageBinding::kSparkIds, ids_);
    bindStorage(StorageBinding::kSparkCommands, commands_);
    list_.use();
    glDispatchCompute(static_cast<GLuint>(groups), 1, 1);
    glMemoryBarrier(GL_COMMAND_BARRIER_BIT | GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
    return static_cast<GLsizei>(groups);
}

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
    const GLsizei groups = list(mesh);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    // Light adds up. What is mapped to the display already cannot, and takes what is left to white.
    glBlendFuncSeparate(GL_ONE, kind.radiance ? GL_ONE : GL_ONE_MINUS_SRC_COLOR, GL_ONE,
                        GL_ONE_MINUS_SRC_ALPHA);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, targets.width, targets.height);
    program.use();
    layout_.bind();
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, commands_.id());
    glMultiDrawArraysIndirect(GL_TRIANGLE_STRIP, nullptr, groups, 0);
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
    glDisable(GL_BLEND);
}

}  // namespace demolish::engine
