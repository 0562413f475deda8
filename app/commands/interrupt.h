// SPDX-License-Identifier: Apache-2.0
// Ctrl-C is heard where something can be ended, so that what was made so far is whole.
#pragma once
#include <array>
#include <csignal>
#include <stdexcept>
#include <string>

namespace demolish {

/// The program ends with this code, as shells have it for SIGINT; `what()` is one sentence.
inline constexpr int kInterruptedCode = 130;
struct Interrupted : std::runtime_error {
    explicit Interrupted(const std::string& sentence) : std::runtime_error(sentence) {}
};

/// While it lives, SIGINT and SIGTERM only ask for the end, and the second of a kind brings it at once. Where
/// they are ignored, as of a job in the background, they stay so.
class InterruptWatch {
  public:
    InterruptWatch();
    ~InterruptWatch();
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    /// The end was asked for since the last watch began.
    static bool asked();

  private:
    static constexpr std::array kSignals{SIGINT, SIGTERM};
    std::array<struct sigaction, kSignals.size()> before_{};
};

}  // namespace demolish
