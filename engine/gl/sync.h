// SPDX-License-Identifier: Apache-2.0
// Owning fence: has the GPU come this far?
#pragma once
#include <glad/gl.h>

#include <cstdint>
#include <utility>

#include "engine/gl/error.h"

namespace demolish::engine::gl {

class Sync {
  public:
    Sync() = default;
    static Sync fence() {
        Sync sync;
        sync.sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
        return sync;
    }
    Sync(Sync&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
    Sync& operator=(Sync&& other) noexcept {
        std::swap(sync_, other.sync_);
        return *this;
    }
    ~Sync() {
        if (sync_ != nullptr) glDeleteSync(sync_);
    }

    /// True when passed; waits `nanoseconds` at most. An empty fence has always passed. Throws GlError when
    /// the driver cannot wait (a lost context), since then it never passes.
    bool wait(uint64_t nanoseconds) const {
        if (sync_ == nullptr) return true;
        const GLenum result = glClientWaitSync(sync_, GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
        if (result == GL_WAIT_FAILED) {
            throwIfError("Waiting for the GPU");
            throw GlError("Waiting for the GPU failed; was its driver reset?");
        }
        return result == GL_ALREADY_SIGNALED || result == GL_CONDITION_SATISFIED;
    }

  private:
    GLsync sync_ = nullptr;
};

}  // namespace demolish::engine::gl
