// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Light that a spark adds: white as it is struck, then yellow, orange and red. Behind what is solid it is not seen.
#include "common/frame.glsl"
#include "common/srgb.glsl"
#include "common/solid.glsl"
in vec2 place;
flat in float heat;
flat in float bright;
layout(location = 0) out vec4 colour;

void main() {
    vec3 ray = rayThrough(gl_FragCoord.xy);
    if (1.0 / gl_FragCoord.w > 1.002 * solidAlong(ray)) discard;
    float across = 1.0 - place.x * place.x, fading = place.y * place.y;
    vec3 glow = mix(vec3(0.9, 0.10, 0.01), mix(vec3(1.0, 0.55, 0.12), vec3(1.0, 0.85, 0.55), smoothstep(0.6, 1.0, heat)), smoothstep(0.05, 0.6, heat));
    colour = vec4(encodeSrgb(glow) * bright * across * fading * smoothstep(0.0, 0.15, heat), 0.0);
}
