// SPDX-License-Identifier: Apache-2.0
// A ring of time stamps; a frame is skipped for reading, never waited for, when the ring is full.
#include "engine/gl/pass_clock.h"

namespace demolish::engine::gl {
namespace {

GLuint64 nanoseconds(GLuint query) {
    GLuint64 time = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &time);
    return time;
}

}  // namespace

void PassClock::stamp(Frame& frame, size_t index) {
    if (index == frame.stamps.size()) {
        GLuint id = 0;
        glCreateQueries(GL_TIMESTAMP, 1, &id);
        frame.stamps.emplace_back(id);
    }
    glQueryCounter(frame.stamps[index].id(), GL_TIMESTAMP);
}

void PassClock::begin() {
    collect();
    if (started_ - read_ == kDepth) ++read_;  // the oldest is given up and its names reused
    current().names.clear();
    stamp(current(), 0);
}

void PassClock::mark(const char* name) {
    current().names.push_back(name);
    stamp(current(), current().names.size());
}

void PassClock::end() {
    ++started_;
}

void PassClock::collect() {
    for (; read_ < started_; ++read_) {
        const Frame& frame = frames_[read_ % kDepth];
        GLint available = 0;
        glGetQueryObjectiv(frame.stamps[frame.names.size()].id(), GL_QUERY_RESULT_AVAILABLE, &available);
        if (available == 0) return;
        read(frame);
    }
}

void PassClock::read(const Frame& frame) {
    passes_.clear();
    GLuint64 before = nanoseconds(frame.stamps[0].id());
    for (size_t i = 0; i < frame.names.size(); ++i) {
        const GLuint64 now = nanoseconds(frame.stamps[i + 1].id());
        passes_.push_back({frame.names[i], now > before ? static_cast<double>(now - before) * 1e-6 : 0.0});
        before = now;
    }
}

double PassClock::lastMs() {
    double sum = 0;
    for (const PassTime& pass : lastPasses()) sum += pass.ms;
    return sum;
}

std::span<const PassTime> PassClock::lastPasses() {
    collect();
    return passes_;
}

}  // namespace demolish::engine::gl
