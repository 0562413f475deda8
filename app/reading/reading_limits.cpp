// SPDX-License-Identifier: Apache-2.0
// setrlimit.
#include "app/reading/reading_limits.h"

#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>

namespace demolish {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

/// Never more than it has been so far.
void limit(__rlimit_resource resource, uint64_t least, uint64_t most) {
    rlimit now{};
    getrlimit(resource, &now);
    now.rlim_max = std::min<rlim_t>(now.rlim_max, most);
    now.rlim_cur = std::min({now.rlim_cur, now.rlim_max, static_cast<rlim_t>(least)});
    setrlimit(resource, &now);
}

void limit(__rlimit_resource resource, uint64_t most) {
    limit(resource, most, most);
}

}  // namespace

uint64_t mostReadingGibibytes() {
    const auto machine =
        static_cast<uint64_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<uint64_t>(sysconf(_SC_PAGESIZE));
    return std::clamp<uint64_t>((machine >> 30) / 2, 1, 8);
}

ReadingTime mostReadingTime(const std::filesystem::path& file) {
    std::error_code error;
    const uintmax_t bytes = std::filesystem::file_size(file, error);
    const std::chrono::seconds computing(20 + (error ? 0 : static_cast<int64_t>(bytes >> 20)));
    return {computing, 5 * computing};
}

void limitThisReader(std::chrono::seconds computing) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const auto seconds = static_cast<uint64_t>(computing.count());
    limit(RLIMIT_CPU, seconds, seconds + 5);  // first SIGXCPU, which tells what it was, then SIGKILL
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, 0);
    if (!kSanitized) limit(RLIMIT_AS, mostReadingGibibytes() << 30);
}

}  // namespace demolish
