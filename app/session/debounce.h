// SPDX-License-Identifier: Apache-2.0
// Waits until a value has come to rest: a slider being dragged must not start a rebuild a frame.
#pragma once
#include <optional>
#include <utility>

namespace demolish {

template <class Value>
class Debounce {
  public:
    /// `rest`: s without a new value before the last one is released.
    explicit Debounce(double rest) : rest_(rest) {}

    void push(Value value, double now) {
        value_ = std::move(value);
        since_ = now;
    }
    void clear() { value_.reset(); }
    bool waiting() const { return value_.has_value(); }
    const std::optional<Value>& pending() const { return value_; }

    /// The last value once it has rested, exactly once.
    std::optional<Value> take(double now) {
        if (!value_ || now - since_ < rest_) return std::nullopt;
        return std::exchange(value_, std::nullopt);
    }

  private:
    double rest_;
    double since_ = 0;
    std::optional<Value> value_;
};

}  // namespace demolish
