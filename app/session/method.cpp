// SPDX-License-Identifier: Apache-2.0
#include "app/session/method.h"

#include <algorithm>
#include <array>

namespace demolish {
namespace {

constexpr std::array<MethodTraits, 5> kTraits = {
    MethodTraits{},
    MethodTraits{.may_rest = false, .times_substeps = 4, .smooth_cracks = false},
    MethodTraits{.on_cpu = true},
    MethodTraits{.pattern_turns = false},
    MethodTraits{.pattern_turns = true},
};

/// The enumerator of a name: its place in the list.
template <class Enum>
std::optional<Enum> find(const std::vector<std::string>& names, const std::string& name) {
    const auto at = std::find(names.begin(), names.end(), name);
    if (at == names.end()) return std::nullopt;
    return static_cast<Enum>(at - names.begin());
}

}  // namespace

const MethodTraits& traitsOf(Method method) {
    return kTraits.at(static_cast<size_t>(method));
}

const std::vector<std::string>& methodNames() {
    static const std::vector<std::string> names{"ours", "heavy", "cores", "pattern", "pattern-at-impact"};
    return names;
}
const char* methodName(Method method) {
    return methodNames().at(static_cast<size_t>(method)).c_str();
}
std::optional<Method> methodOf(const std::string& name) {
    return find<Method>(methodNames(), name);
}

const std::vector<std::string>& patternNames() {
    static const std::vector<std::string> names{"uniform", "radial", "slabs", "bricks", "splinters"};
    return names;
}
const char* patternName(Pattern pattern) {
    return patternNames().at(static_cast<size_t>(pattern)).c_str();
}
std::optional<Pattern> patternOf(const std::string& name) {
    return find<Pattern>(patternNames(), name);
}

Pattern usualPattern(Method method) {
    return method == Method::kPatternAtImpact ? Pattern::kRadial : Pattern::kUniform;
}

}  // namespace demolish
