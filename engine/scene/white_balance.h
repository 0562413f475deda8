// SPDX-License-Identifier: Apache-2.0
// What a camera set to a colour temperature multiplies red, green and blue with.
#pragma once
#include <glm/glm.hpp>

namespace demolish::engine {

inline constexpr float kDaylight = 6500;                                    ///< K, leaves colours as they are
inline constexpr float kLeastTemperature = 1667, kMostTemperature = 25000;  // K

/// Light of a black body of this temperature (K) becomes grey; luminance of grey stays.
glm::vec3 whiteBalance(float temperature);

}  // namespace demolish::engine
