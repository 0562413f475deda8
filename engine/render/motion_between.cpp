// SPDX-License-Identifier: Apache-2.0
// Compute passes over all slots.
#include "engine/render/motion_between.h"

#include <initializer_list>

#include "engine/gl/error.h"

namespace demolish::engine {
namespace {

constexpr GLint kShare = 0, kCount = 1, kFrameSeconds = 2;
constexpr size_t kMotionBytes = 32, kFragmentBytes = 4, kFlyingBytes = 32;
constexpr size_t kGroup = 64;
constexpr StreamId kFlying[] = {StreamId::kGrains, StreamId::kPuffs};

void copy(const gl::Buffer& from, const gl::Buffer& to, size_t bytes) {
    glCopyNamedBufferSubData(from.id(), to.id(), 0, 0, static_cast<GLsizeiptr>(bytes));
}

void fit(gl::Buffer& buffer, size_t bytes) {
    if (buffer.size() != bytes) buffer = gl::Buffer::immutable(bytes);
}

void clear(const gl::Buffer& buffer) {
    glClearNamedBufferData(buffer.id(), GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, nullptr);
}

void run(gl::Program& program, std::initializer_list<const gl::Buffer*> buffers, float share, size_t count) {
    GLuint unit = 0;
    for (const gl::Buffer* buffer : buffers) glBindBufferBase(GL_SHADER_STORAGE_BUFFER, unit++, buffer->id());
    program.set(kShare, share);
    program.set(kCount, static_cast<uint32_t>(count));
    program.use();
    glDispatchCompute(static_cast<GLuint>((count + kGroup - 1) / kGroup), 1, 1);
}

}  // namespace

MotionBetween::MotionBetween(const std::filesystem::path& shader_folder)
    : fragments_(shader_folder, {"motion_between.comp"}), effects_(shader_folder, {"effects_between.comp"}) {}

void MotionBetween::remember(const FractureMesh& mesh) {
    const size_t particles = mesh.particleCount();
    if (particles == 0) return;
    fit(fragment_before_, particles * kFragmentBytes);
    fit(transforms_.before, particles * kMotionBytes);
    fit(transforms_.after, particles * kMotionBytes);
    copy(mesh.stream(StreamId::kParticleFragment), fragment_before_, particles * kFragmentBytes);
    copy(mesh.stream(StreamId::kTransforms), transforms_.before, particles * kMotionBytes);
    had_effects_ = mesh.effectsShown();
    for (size_t i = 0; i < flying_.size() && had_effects_; ++i) {
        const gl::Buffer& shown = mesh.stream(kFlying[i]);
        fit(flying_[i].before, shown.size());
        copy(shown, flying_[i].before, shown.size());
    }
    remembered_ = particles;
    gl::throwIfError("Remembering a frame");
}

void MotionBetween::keepEffects(const FractureMesh& mesh) {
    for (size_t i = 0; i < flying_.size(); ++i) {
        const gl::Buffer& shown = mesh.stream(kFlying[i]);
        fit(flying_[i].after, shown.size());
        copy(shown, flying_[i].after, shown.size());
        if (had_effects_) continue;
        fit(flying_[i].before, shown.size());
        clear(flying_[i].before);
    }
}

void MotionBetween::placeFragments(FractureMesh& mesh, float share) {
    gl::Buffer& shown = mesh.stream(StreamId::kTransforms);
    if (!moved_) copy(shown, transforms_.after, remembered_ * kMotionBytes);
    run(fragments_, {&fragment_before_, &transforms_.before, &transforms_.after, &shown}, share, remembered_);
}

void MotionBetween::placeEffects(FractureMesh& mesh, float share, float frame_s) {
    if (!moved_) keepEffects(mesh);
    for (size_t i = 0; i < flying_.size(); ++i) {
        gl::Buffer& shown = mesh.stream(kFlying[i]);
        effects_.set(kFrameSeconds, kFlying[i] == StreamId::kGrains ? frame_s : 0.0f);
        run(effects_, {&flying_[i].before, &flying_[i].after, &shown}, share, shown.size() / kFlyingBytes);
    }
}

void MotionBetween::place(FractureMesh& mesh, float share, float frame_s) {
    if (remembered_ == 0 || remembered_ != mesh.particleCount()) return;
    placeFragments(mesh, share);
    with_effects_ = mesh.effectsShown();
    if (with_effects_) placeEffects(mesh, share, frame_s);
    moved_ = true;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
    gl::throwIfError("Moving a body between two frames");
}

void MotionBetween::restore(FractureMesh& mesh) {
    if (!moved_) return;
    copy(transforms_.after, mesh.stream(StreamId::kTransforms), remembered_ * kMotionBytes);
    for (size_t i = 0; i < flying_.size() && with_effects_; ++i)
        copy(flying_[i].after, mesh.stream(kFlying[i]), flying_[i].after.size());
    moved_ = false;
}

}  // namespace demolish::engine
