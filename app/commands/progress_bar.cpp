// SPDX-License-Identifier: Apache-2.0
// Drawn on stderr, so that stdout stays clean for tables.
#include "app/commands/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace demolish {
namespace {

constexpr int kWidth = 30;
constexpr std::chrono::milliseconds kRedraw{80};

}  // namespace

ProgressBar::ProgressBar() : on_terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressBar::~ProgressBar() {
    finish();
}

void ProgressBar::show(double fraction, const std::string& label) {
    const auto now = Clock::now();
    if (label != label_) {
        finish();
        label_ = label;
        begun_ = now;
        drawn_ = {};
        tenths_ = -1;
    }
    fraction = std::clamp(fraction, 0.0, 1.0);
    const int tenths = static_cast<int>(fraction * 10);
    const bool due = on_terminal_ ? now - drawn_ >= kRedraw || fraction >= 1 : tenths > tenths_;
    if (!due) return;
    drawn_ = now;
    tenths_ = tenths;
    if (!on_terminal_) {
        std::fprintf(stderr, "%s: %d %%\n", label_.c_str(), tenths * 10);
        return;
    }
    const int filled = static_cast<int>(fraction * kWidth);
    const double spent = std::chrono::duration<double>(now - begun_).count();
    const double left = fraction > 0.02 ? spent * (1 - fraction) / fraction : 0;
    std::fprintf(stderr, "\r%-24s [%s%s] %3.0f %%  %4.0f s left ", label_.c_str(),
                 std::string(filled, '#').c_str(), std::string(kWidth - filled, ' ').c_str(), 100 * fraction,
                 left);
    std::fflush(stderr);
    line_open_ = true;
}

void ProgressBar::finish() {
    if (line_open_) std::fputc('\n', stderr);
    line_open_ = false;
}

}  // namespace demolish
