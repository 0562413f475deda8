// SPDX-License-Identifier: Apache-2.0
// The dark inside of a crack: far deeper than wide, so that little light comes back.
#include "common/crack_colour.glsl"
const float kDark = 0.93;  // share of the material that it hides

// `across`: px from the middle.
float crackCover(float across, float half_width, float strength) {
    return kDark * strength * clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
}
