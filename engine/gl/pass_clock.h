// SPDX-License-Identifier: Apache-2.0
// GPU time of a frame and of each of its passes, read frames later so that nobody waits.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "engine/gl/object.h"
#include "engine/gl/pass_time.h"

namespace demolish::engine::gl {

struct QueryTraits {
    static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};

/// begin(), mark() after each pass, end() once a frame. Time stamps come from a ring of kDepth frames.
class PassClock {
  public:
    void begin();
    /// The pass `name` (a literal) ends here and the next one begins.
    void mark(const char* name);
    void end();
    /// From begin to the last mark of the youngest finished frame, ms; 0 before there is one.
    double lastMs();
    /// The passes of that frame, in order.
    std::span<const PassTime> lastPasses();

  private:
    struct Frame {
        std::vector<Object<QueryTraits>> stamps;  ///< grows to the largest number of marks
        std::vector<const char*> names;           ///< of the spans between the stamps
    };
    static constexpr int kDepth = 4;
    void stamp(Frame& frame, size_t index);
    void collect();
    void read(const Frame& frame);
    Frame& current() { return frames_[started_ % kDepth]; }

    std::array<Frame, kDepth> frames_;
    std::vector<PassTime> passes_;
    int started_ = 0, read_ = 0;
};

}  // namespace demolish::engine::gl
