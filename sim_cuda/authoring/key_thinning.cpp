// SPDX-License-Identifier: Apache-2.0
// Douglas and Peucker, in time.
#include "sim_cuda/authoring/key_thinning.h"

#include <algorithm>

namespace demolish {
namespace {

constexpr size_t kLooksOfAKey = 16;

struct Motion {
    const std::vector<double>& times;
    const std::vector<std::vector<Double3>>& vectors;

    /// How far a straight line from moment a to moment b is from moment `at`.
    double error(size_t a, size_t b, size_t at) const {
        const double share = (times[at] - times[a]) / (times[b] - times[a]);
        double most = 0;
        for (size_t v = 0; v < vectors[at].size(); ++v) {
            const Double3 line = vectors[a][v] + (vectors[b][v] - vectors[a][v]) * share;
            most = std::max(most, length(vectors[at][v] - line));
        }
        return most;
    }
};

}  // namespace

std::vector<double> looksAt(const std::vector<double>& times, size_t most) {
    const size_t stride = (times.size() + most - 1) / most;
    const size_t each = std::clamp<size_t>(most / times.size(), 1, kLooksOfAKey);
    std::vector<double> looks{0};
    for (size_t k = stride - 1; k < times.size(); k += stride) {
        const double from = looks.back();
        for (size_t i = 1; i <= each; ++i)
            looks.push_back(from + (times[k] - from) * double(i) / double(each));
    }
    if (looks.back() < times.back()) looks.push_back(times.back());
    return looks;
}

std::vector<size_t> neededMoments(const std::vector<double>& times,
                                  const std::vector<std::vector<Double3>>& vectors) {
    const Motion motion{times, vectors};
    std::vector<size_t> needed{0};
    std::vector<std::pair<size_t, size_t>> open{{0, times.size() - 1}};
    while (!open.empty()) {
        const auto [first, last] = open.back();
        open.pop_back();
        size_t worst = last;
        double error = 1;
        for (size_t k = first + 1; k < last; ++k)
            if (const double own = motion.error(first, last, k); own > error) {
                error = own;
                worst = k;
            }
        if (last > first) needed.push_back(worst);
        if (worst == last) continue;
        open.emplace_back(first, worst);
        open.emplace_back(worst, last);
    }
    std::sort(needed.begin(), needed.end());
    needed.erase(std::unique(needed.begin(), needed.end()), needed.end());
    return needed;
}

}  // namespace demolish
