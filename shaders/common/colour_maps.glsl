// SPDX-License-Identifier: Apache-2.0
// Colours of the particle view.
vec3 fromOklab(vec3 lab) {
    float l = lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z;
    float m = lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z;
    float s = lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z;
    vec3 lms = vec3(l * l * l, m * m * m, s * s * s);
    return max(vec3(dot(lms, vec3(4.0767416621, -3.3077115913, 0.2309699292)),
                    dot(lms, vec3(-1.2684380046, 2.6097574011, -0.3413193965)),
                    dot(lms, vec3(-0.0041960863, -0.7034186147, 1.7076147010))), 0.0);
}

// A hue of its own for each fragment, all equally light and strong to the eye.
vec3 fragmentColour(uint slot) {
    uint h = slot * 0x9e3779b1u;
    h = (h ^ (h >> 15)) * 0x85ebca77u;
    h ^= h >> 13;
    float hue = float(h & 0xffffu) * (6.2831853 / 65536.0);
    float light = 0.66 + 0.12 * float((h >> 16) & 0xffu) / 255.0;
    return fromOklab(vec3(light, 0.125 * cos(hue), 0.125 * sin(hue)));
}

// Dark blue over red to pale yellow; lightness rises evenly, so order shows in grey print as well.
vec3 rampColour(float t) {
    float x = clamp(t, 0.0, 1.0);
    float light = 0.28 + 0.66 * x;
    float hue = mix(-1.75, 1.75, smoothstep(0.0, 1.0, x));
    float strength = 0.13 + 0.07 * sin(3.14159265 * x);
    return fromOklab(vec3(light, strength * cos(hue), strength * sin(hue)));
}
