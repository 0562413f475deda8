// SPDX-License-Identifier: Apache-2.0
// Sums in 32 bits: hundreds of pictures leave no steps.
#include "engine/render/film.h"

#include <array>
#include <string>

#include "engine/gl/error.h"

namespace demolish::engine {
namespace {

constexpr GLint kCurve = 0, kExposure = 1, kCurveMore = 16;
constexpr GLuint kInput = 0;

}  // namespace

Film::Film(const std::filesystem::path& shader_folder)
    : shaders_(shader_folder), add_(shader_folder, {"whole_picture.vert", "film_add.frag"}) {}

void Film::begin(int width, int height) {
    if (width != width_ || height != height_) {
        picture_ = gl::Texture::make2d(GL_RGBA16F, width, height);
        sum_ = gl::Texture::make2d(GL_RGBA32F, width, height);
        picture_target_ = gl::Framebuffer({&picture_}, nullptr);
        sum_target_ = gl::Framebuffer({&sum_}, nullptr);
        width_ = width;
        height_ = height;
    }
    constexpr std::array<float, 4> kNothing{};
    glClearNamedFramebufferfv(sum_target_.id(), GL_COLOR, 0, kNothing.data());
    pictures_ = 0;
    gl::throwIfError("Preparing a film");
}

void Film::cover(unsigned framebuffer) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width_, height_);
    no_attributes_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Film::add() {
    picture_.bind(kInput);
    add_.use();
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    cover(sum_target_.id());
    glDisable(GL_BLEND);
    ++pictures_;
}

void Film::develop(const Lighting& light, unsigned framebuffer) {
    gl::Program& program = develop_[light.tone];
    if (program.id() == 0) {
        program = gl::Program(shaders_, {"whole_picture.vert", "film_develop.frag"},
                              "#define TONE " + std::to_string(static_cast<int>(light.tone)) + "\n");
        const ToneParameters tone = toneParameters(light.tone);
        program.set(kCurve, tone.first);
        program.set(kCurveMore, tone.second);
    }
    program.set(kExposure, glm::vec4(light.exposure * whiteBalance(light.temperature),
                                     1.0f / static_cast<float>(pictures_)));
    program.use();
    sum_.bind(kInput);
    cover(framebuffer);
    gl::throwIfError("Developing a film");
}

}  // namespace demolish::engine
