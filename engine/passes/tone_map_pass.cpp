// A compute pass: on data-centre GPUs only few multiprocessors draw, but all of them compute.
#include "engine/passes/tone_map_pass.h"

#include <cmath>
#include <string>

namespace demolish::engine {
namespace {

constexpr GLint kCurve = 0, kHasOcclusion = 1;

/// x^a / (x^(a d) b + c): contrast a in the middle, shoulder d towards white; b and c follow from where
/// middle grey and white land (Lottes, "Advanced techniques and optimization of HDR color pipelines", GDC
/// 2016).
glm::vec4 toneCurve() {
    constexpr float kContrast = 1.28f, kShoulder = 0.97f, kWhite = 9.0f, kGreyIn = 0.18f, kGreyOut = 0.19f;
    const float grey = std::pow(kGreyIn, kContrast), grey_d = std::pow(kGreyIn, kContrast * kShoulder);
    const float white = std::pow(kWhite, kContrast), white_d = std::pow(kWhite, kContrast * kShoulder);
    const float b = (white * kGreyOut - grey) / ((white_d - grey_d) * kGreyOut);
    const float c = (white_d * grey - white * grey_d * kGreyOut) / ((white_d - grey_d) * kGreyOut);
    return {kContrast, kShoulder, b, c};
}

}  // namespace

ToneMapPass::ToneMapPass(const std::filesystem::path& shaders) : shaders_(shaders) {}

gl::Program& ToneMapPass::programFor(int samples) {
    gl::Program& program = samples >= 4 ? quadruple_ : samples == 2 ? double_ : single_;
    if (program.id() == 0) {
        program =
            gl::Program(shaders_, {"tone_map.comp"}, "#define SAMPLES " + std::to_string(samples) + "\n");
        program.set(kCurve, toneCurve());
    }
    return program;
}

void ToneMapPass::run(const RenderTargets& targets, const gl::Texture* occlusion) {
    gl::Program& program = programFor(targets.samples);
    program.set(kHasOcclusion, occlusion != nullptr ? 1 : 0);
    program.use();
    targets.hdr.bind(0);
    targets.depth.bind(1);
    if (occlusion != nullptr) occlusion->bind(2);
    glBindImageTexture(0, targets.display.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    glDispatchCompute((targets.width + 7) / 8, (targets.height + 7) / 8, 1);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
}

}  // namespace demolish::engine
