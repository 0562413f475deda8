#version 450 core
// The dark inside of a crack: no even stroke, but wider and narrower, darker and lighter along its way.
#include "common/noise.glsl"
in float across;
in float half_width;
in float strength;
in vec3 rest;
layout(location = 0) out vec4 material_out;
layout(location = 0) uniform float width;  // m

const float kFine = 4.0, kCoarse = 13.0;  // wavelengths, in widths

void main() {
    float uneven = 0.5 * noise(rest / (kFine * width)).w + noise(rest / (kCoarse * width)).w;
    float edge = half_width * clamp(1.0 + 0.9 * uneven, 0.25, 1.0);
    float cover = clamp(edge + 0.5 - abs(across), 0.0, 1.0);
    float dark = clamp(0.78 + 0.5 * uneven, 0.35, 0.95);
    material_out = vec4(vec3(0.09, 0.085, 0.08), dark * cover * strength);  // albedo as its square root
}
