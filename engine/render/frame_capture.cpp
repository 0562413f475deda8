// SPDX-License-Identifier: Apache-2.0
// A ring of pixel-pack buffers: a frame is copied to memory while the next ones are drawn.
#include "engine/render/frame_capture.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/error.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/sync.h"
#include "engine/gl/texture.h"

namespace demolish::engine {
namespace {

constexpr uint64_t kNoWait = 0, kOneSecond = 1'000'000'000;

}  // namespace

struct FrameCapture::State {
    struct Slot {
        gl::Buffer buffer;
        const uint8_t* mapped = nullptr;
        gl::Sync done;
        uint64_t frame = 0;
    };

    State(int width_px, int height_px, Sink frame_sink, int buffer_count)
        : width(width_px),
          height(height_px),
          sink(std::move(frame_sink)),
          colour(gl::Texture::make2d(GL_RGBA8, width, height)),
          target({&colour}, nullptr),
          slots(buffer_count) {
        const size_t bytes = size_t{4} * width * height;
        constexpr GLbitfield kFlags = GL_MAP_READ_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        for (Slot& slot : slots) {
            slot.buffer = gl::Buffer::immutable(bytes, nullptr, kFlags | GL_CLIENT_STORAGE_BIT);
            slot.mapped = static_cast<const uint8_t*>(
                glMapNamedBufferRange(slot.buffer.id(), 0, static_cast<GLsizeiptr>(bytes), kFlags));
        }
    }

    bool oldestIsDone(uint64_t wait) const { return slots[delivered % slots.size()].done.wait(wait); }

    void deliverOldest() {
        const Slot& slot = slots[delivered++ % slots.size()];
        Image image;
        image.width = width;
        image.height = height;
        const size_t row = size_t{4} * width;
        image.pixels.resize(row * height);
        for (int y = 0; y < height; ++y) {  // GL's rows go up
            std::memcpy(image.pixels.data() + row * y, slot.mapped + row * (height - 1 - y), row);
        }
        sink(slot.frame, std::move(image));
    }

    void waitAndDeliverOldest() {
        while (!oldestIsDone(kOneSecond)) {
        }
        deliverOldest();
    }

    int width, height;
    Sink sink;
    gl::Texture colour;
    gl::Framebuffer target;
    std::vector<Slot> slots;
    size_t submitted = 0, delivered = 0;
};

FrameCapture::FrameCapture(int width, int height, Sink sink, int buffer_count)
    : state_(std::make_unique<State>(width, height, std::move(sink), std::max(buffer_count, 1))) {
    gl::throwIfError("Setting up frame capture");
}

FrameCapture::~FrameCapture() = default;

unsigned FrameCapture::framebuffer() const {
    return state_->target.id();
}

void FrameCapture::submit(uint64_t frame) {
    State& s = *state_;
    while (s.delivered < s.submitted && s.oldestIsDone(kNoWait)) s.deliverOldest();
    if (s.submitted - s.delivered == s.slots.size()) s.waitAndDeliverOldest();
    State::Slot& slot = s.slots[s.submitted++ % s.slots.size()];
    slot.frame = frame;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, s.target.id());
    glBindBuffer(GL_PIXEL_PACK_BUFFER, slot.buffer.id());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, s.width, s.height, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glMemoryBarrier(GL_CLIENT_MAPPED_BUFFER_BARRIER_BIT);
    slot.done = gl::Sync::fence();
    gl::throwIfError("Reading a frame back");
}

void FrameCapture::finish() {
    while (state_->delivered < state_->submitted) state_->waitAndDeliverOldest();
}

}  // namespace demolish::engine
