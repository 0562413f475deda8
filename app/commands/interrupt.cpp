// SPDX-License-Identifier: Apache-2.0
// A flag, all that a signal handler may touch.
#include "app/commands/interrupt.h"

#include <atomic>

namespace demolish {
namespace {

std::atomic<bool> end_asked = false;  // threads read it, and a signal handler may write it
static_assert(std::atomic<bool>::is_always_lock_free);

void ask(int) {
    end_asked = true;
}

}  // namespace

InterruptWatch::InterruptWatch() {
    end_asked = false;
    struct sigaction action {};
    action.sa_handler = ask;
    action.sa_flags = SA_RESETHAND | SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < kSignals.size(); ++k) {
        sigaction(kSignals[k], nullptr, &before_[k]);
        if (before_[k].sa_handler != SIG_IGN) sigaction(kSignals[k], &action, nullptr);
    }
}

InterruptWatch::~InterruptWatch() {
    for (size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before_[k], nullptr);
}

bool InterruptWatch::asked() {
    return end_asked;
}

}  // namespace demolish
