// A ring of queries; a span is skipped for reading, never waited for, when the ring is full.
#include "engine/gl/timer_query.h"

namespace demolish::engine::gl {

TimerQuery::TimerQuery() {
    for (auto& query : queries_) {
        GLuint id = 0;
        glCreateQueries(GL_TIME_ELAPSED, 1, &id);
        query = Object<QueryTraits>(id);
    }
}

void TimerQuery::begin() {
    collect();
    if (started_ - read_ == kDepth) ++read_;  // the oldest is given up and its name reused
    glBeginQuery(GL_TIME_ELAPSED, queries_[started_ % kDepth].id());
}

void TimerQuery::end() {
    glEndQuery(GL_TIME_ELAPSED);
    ++started_;
}

void TimerQuery::collect() {
    while (read_ < started_) {
        const GLuint query = queries_[read_ % kDepth].id();
        GLint available = 0;
        glGetQueryObjectiv(query, GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) return;
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(query, GL_QUERY_RESULT, &nanoseconds);
        last_ms_ = static_cast<double>(nanoseconds) * 1e-6;
        ++read_;
    }
}

double TimerQuery::lastMs() {
    collect();
    return last_ms_;
}

}  // namespace demolish::engine::gl
