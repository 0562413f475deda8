// GPU time of a span of commands, read frames later so that nobody waits.
#pragma once
#include <array>

#include "engine/gl/object.h"

namespace demolish::engine::gl {

struct QueryTraits {
    static void destroy(GLuint id) { glDeleteQueries(1, &id); }
};

/// begin()/end() once a frame, not nested. Results come from a ring of kDepth queries.
class TimerQuery {
  public:
    TimerQuery();
    void begin();
    void end();
    /// Milliseconds of the youngest finished span; 0 before there is one.
    double lastMs();

  private:
    static constexpr int kDepth = 4;
    void collect();
    std::array<Object<QueryTraits>, kDepth> queries_;
    int started_ = 0, read_ = 0;
    double last_ms_ = 0.0;
};

}  // namespace demolish::engine::gl
