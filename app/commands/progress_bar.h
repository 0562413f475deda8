// SPDX-License-Identifier: Apache-2.0
// One line that grows: on a terminal redrawn in place, elsewhere a line every tenth.
#pragma once
#include <chrono>
#include <string>

namespace demolish {

class ProgressBar {
  public:
    ProgressBar();
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// `fraction` 0..1. A new label starts a new line.
    void show(double fraction, const std::string& label);
    void finish();

  private:
    using Clock = std::chrono::steady_clock;
    bool on_terminal_;
    std::string label_;
    Clock::time_point begun_;
    Clock::time_point drawn_;
    int tenths_ = -1;
    bool line_open_ = false;
};

}  // namespace demolish
