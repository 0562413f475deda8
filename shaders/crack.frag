#version 450 core
// The dark inside of a crack.
in float across;
flat in float half_width;
flat in float strength;
layout(location = 0) out vec4 colour;

void main() {
    float cover = clamp(half_width + 0.5 - abs(across), 0.0, 1.0);
    colour = vec4(vec3(0.012, 0.010, 0.009), 0.92 * cover * strength);
}
