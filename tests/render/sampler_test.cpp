// SPDX-License-Identifier: Apache-2.0
// No shader reads depths by a sampler that compares them unless it asks for that: drivers take it for an
// error, or for nothing, or give nonsense.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "tests/render/gl_fixture.h"
#include "tests/render/scenes.h"

namespace demolish::engine::test {
namespace {

std::set<std::string> complaints;

bool comparesNothing(GLenum type) {
    for (const GLenum plain : {GL_SAMPLER_2D, GL_SAMPLER_3D, GL_SAMPLER_2D_ARRAY, GL_UNSIGNED_INT_SAMPLER_2D})
        if (type == plain) return true;
    return false;
}

void checkSamplers() {
    GLint program = 0, uniforms = 0;
    glGetIntegerv(GL_CURRENT_PROGRAM, &program);
    if (program == 0) return;
    glGetProgramiv(static_cast<GLuint>(program), GL_ACTIVE_UNIFORMS, &uniforms);
    for (GLuint k = 0; k < static_cast<GLuint>(uniforms); ++k) {
        char name[128];
        GLint size = 0, unit = 0, sampler = 0, mode = GL_NONE;
        GLenum type = 0;
        glGetActiveUniform(static_cast<GLuint>(program), k, sizeof name, nullptr, &size, &type, name);
        if (!comparesNothing(type)) continue;
        glGetUniformiv(static_cast<GLuint>(program), glGetUniformLocation(static_cast<GLuint>(program), name),
                       &unit);
        glGetIntegeri_v(GL_SAMPLER_BINDING, static_cast<GLuint>(unit), &sampler);
        if (sampler == 0) continue;
        glGetSamplerParameteriv(static_cast<GLuint>(sampler), GL_TEXTURE_COMPARE_MODE, &mode);
        if (mode != GL_NONE) complaints.insert(std::string(name) + " of unit " + std::to_string(unit));
    }
}

/// Calls `check` before each of the calls through `pointer`, as long as it lives.
template <auto& pointer>
class Watched;
template <class... Arguments, void (*&pointer)(Arguments...)>
class Watched<pointer> {
  public:
    Watched() : own_(pointer) {
        real = pointer;
        pointer = [](Arguments... arguments) {
            checkSamplers();
            real(arguments...);
        };
    }
    ~Watched() { pointer = own_; }
    Watched(const Watched&) = delete;
    Watched& operator=(const Watched&) = delete;

  private:
    static inline void (*real)(Arguments...) = nullptr;
    void (*own_)(Arguments...);
};

class SamplerTest : public GlTest {};

TEST_F(SamplerTest, OnlyShadersThatAskForItCompareDepths) {
    complaints.clear();
    const Watched<glad_glDrawArrays> arrays;
    const Watched<glad_glDrawArraysInstanced> instanced;
    const Watched<glad_glDrawArraysIndirect> indirect;
    const Watched<glad_glDrawElementsIndirect> elements;
    const Watched<glad_glDispatchCompute> dispatches;
    const Watched<glad_glDispatchComputeIndirect> indirect_dispatches;
    // Some drivers look at the shaders in force even as they clear.
    const Watched<glad_glClearNamedFramebufferfv> clears;
    const Watched<glad_glClearNamedFramebufferuiv> whole_clears;
    for (const RenderQuality quality : {RenderQuality::kFull, RenderQuality::kDraft})
        for (const float refraction : {1.0f, 1.5f})
            for (const Rasteriser rasteriser : {Rasteriser::kCompute, Rasteriser::kDraw}) {
                Scene scene = wholeBlock();
                scene.view.width = 160;
                scene.view.height = 90;
                scene.view.quality = quality;
                scene.view.rasteriser = rasteriser;
                scene.view.look.refraction_index = refraction;
                scene.view.colliders = solidBlock().view.colliders;
                drawPicture(renderer(), scene);
                const glm::vec3 before = glm::mix(scene.view.camera.eye, scene.view.camera.target, 0.6f);
                writeEffects(*scene.mesh, {{before, 0.05f, {0, 0x7fff0000u}, 3}},
                             {{before, 0.3f, 1, 0.3f, 1}});
                drawPicture(renderer(), scene);
            }
    for (const std::string& complaint : complaints) ADD_FAILURE() << complaint;
}

}  // namespace
}  // namespace demolish::engine::test
