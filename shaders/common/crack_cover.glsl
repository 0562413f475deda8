// SPDX-License-Identifier: Apache-2.0
// The dark inside of a crack: no even stroke.
#include "common/crack_colour.glsl"
const float kFine = 4.0, kCoarse = 13.0;  // wavelengths, in widths

// Share of the material that the crack hides. `across`: px from the middle; `rest`: m.
float crackCover(vec3 rest, float width, float across, float half_width, float strength) {
    float uneven = 0.5 * noise(rest, 1.0 / (kFine * width)).w + noise(rest, 1.0 / (kCoarse * width)).w;
    float edge = half_width * clamp(1.0 + 0.9 * uneven, 0.25, 1.0);
    float cover = clamp(edge + 0.5 - abs(across), 0.0, 1.0);
    float dark = clamp(0.78 + 0.5 * uneven, 0.35, 0.95);
    return dark * cover * strength;
}
