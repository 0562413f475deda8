// SPDX-License-Identifier: Apache-2.0
// Median of the slopes between all pairs.
#include "tests/fuzz/soak/trend.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>

namespace demolish::fuzz {
namespace {

constexpr size_t kLeastRounds = 9;

std::vector<double> afterWarmUp(const std::vector<Usage>& samples, double Usage::*what) {
    std::vector<double> values;
    for (size_t k = samples.size() / 3; k < samples.size(); ++k) values.push_back(samples[k].*what);
    return values;
}

std::string sentence(const char* what, double grown, size_t rounds) {
    char text[160];
    std::snprintf(text, sizeof text, "%s grew by %.1f in %zu rounds", what, grown, rounds);
    return text;
}

}  // namespace

double trend(const std::vector<double>& samples) {
    std::vector<double> slopes;
    for (size_t i = 0; i < samples.size(); ++i)
        for (size_t j = i + 1; j < samples.size(); ++j)
            slopes.push_back((samples[j] - samples[i]) / static_cast<double>(j - i));
    if (slopes.empty()) return 0;
    const auto middle = slopes.begin() + static_cast<ptrdiff_t>(slopes.size() / 2);
    std::nth_element(slopes.begin(), middle, slopes.end());
    return *middle * static_cast<double>(samples.size() - 1);
}

std::vector<std::string> growth(const std::vector<Usage>& samples) {
    if (samples.size() < kLeastRounds)
        return {"only " + std::to_string(samples.size()) + " rounds: too few to tell"};
    struct Limit {
        const char* name;
        double Usage::*what;
        double share, least;  ///< that it may grow: a share of its middle, and so much in any case
    };
    constexpr Limit kLimits[] = {{"resident memory (MiB)", &Usage::resident, 0.05, 16},
                                 {"memory of the GPU (MiB)", &Usage::gpu, 0.05, 32},
                                 {"open files", &Usage::files, 0, 0.5}};
    std::vector<std::string> faults;
    for (const Limit& limit : kLimits) {
        std::vector<double> values = afterWarmUp(samples, limit.what);
        const double grown = trend(values);
        std::nth_element(values.begin(), values.begin() + static_cast<ptrdiff_t>(values.size() / 2),
                         values.end());
        if (grown > std::max(limit.least, limit.share * values[values.size() / 2]))
            faults.push_back(sentence(limit.name, grown, values.size()));
    }
    return faults;
}

}  // namespace demolish::fuzz
