#version 450 core
// The dark inside of a crack.
in float across;
flat in float half_width;
flat in float strength;
layout(location = 0) out vec4 material_out;

void main() {
    float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
    material_out = vec4(vec3(0.09, 0.085, 0.08), 0.95 * cover * strength);  // albedo as its square root
}
