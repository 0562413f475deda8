// SPDX-License-Identifier: Apache-2.0
// Ways to break a body: ours, and those that the paper sets beside its own (4.4, Fig. 5). A method is a value
// of the shot; what it stands for is decided here and nowhere else.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sim_cuda/api/params.h"

namespace demolish {

enum class Method {
    kOurs,             ///< bonds where something breaks, rigid bodies elsewhere
    kHeavy,            ///< the paper's Method 2: every bond stepped all the time, faces as the cells are
    kCores,            ///< its Method 4: ours on all cores of the CPU
    kPattern,          ///< its Method 3: pieces that are cut beforehand, the same wherever it is hit
    kPatternAtImpact,  ///< its Method 1: pieces of a pattern centred on the impact and turned to it
};

/// What a method makes of a shot.
struct MethodTraits {
    bool may_rest = true;         ///< pieces may go on as rigid bodies, and sleep, where the shot says so
    uint32_t times_substeps = 1;  ///< as many as our method takes
    bool smooth_cracks = true;    ///< as SolverParams; and inner faces have a relief
    bool on_cpu = false;          ///< and on no GPU
    std::optional<bool> pattern_turns = std::nullopt;  ///< of preset pieces: at the impact; none: bonds break
};
const MethodTraits& traitsOf(Method method);

/// Names as on the command line, in the order of the enumerators.
const std::vector<std::string>& methodNames();
const char* methodName(Method method);
std::optional<Method> methodOf(const std::string& name);

const std::vector<std::string>& patternNames();
const char* patternName(Pattern pattern);
std::optional<Pattern> patternOf(const std::string& name);

/// The pattern that a method takes unless another is chosen.
Pattern usualPattern(Method method);

}  // namespace demolish
