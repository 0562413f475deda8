// SPDX-License-Identifier: Apache-2.0
#version 450 core
// What a puff adds along a ray: its light times its optical depth, and the depth itself. Sums do not hang on the order.
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/gbuffer.glsl"
#include "common/sky.glsl"
#include "common/solid.glsl"
layout(location = 0) uniform vec4 dust;      // rgb: colour; w: 1/m, of its lumps
in vec2 corner;
in vec3 across;  // m, from the middle
flat in vec4 centre_radius;
flat in vec3 depth_age_heat;
flat in float sunlit;
layout(location = 0) out vec4 light_depth;

const vec3 kSmoke = vec3(0.30, 0.29, 0.28);

// Henyey and Greenstein's, forward.
float phase(float cosine) {
    const float g = 0.45;
    float k = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (k * sqrt(k));
}

void main() {
    float d2 = dot(corner, corner);
    if (d2 >= 1.0) discard;
    float radius = centre_radius.w, bump = sqrt(1.0 - d2);
    vec3 ray = rayThrough(gl_FragCoord.xy * pixels), forward = normalize(frame.ray_forward.xyz);
    float along = dot(centre_radius.xyz - frame.eye.xyz, forward);
    float front = max(along - radius * bump, frame.depth_range.x), end = min(along + radius * bump, solidAlong(ray));
    // The share of the chord in front of what is solid; nothing close to the eye.
    float share = clamp((end - front) / (2.0 * radius * bump), 0.0, 1.0) * smoothstep(0.0, 0.3, front / radius);
    if (share == 0.0) discard;
    vec3 normal = normalize(across / radius - bump * forward);
    vec3 at = centre_radius.xyz + 0.7 * radius * normal;
    // Lumps stand in the world, so that puffs which overlap wear alike; they drift upwards a little.
    vec3 q = dust.w * (at - vec3(0.0, 0.05 * depth_age_heat.y, 0.0));
    vec4 lump = noise(q);
    vec3 curled = q + 0.3 * lump.xyz;
    float worn = 0.8 * lump.w + noise(curled * 2.3 + 3.1).w;
#ifdef FULL
    worn += 0.6 * noise(curled * 5.1).w;
#endif
    // Neither a rim nor a plateau, or a single puff is a disc: it thins out to nothing, and lumps wear it everywhere.
    float round_off = (1.0 - d2) * (1.0 - d2), eaten = 0.3 * min(depth_age_heat.y, 1.5);
    float density = 2.3 * round_off * smoothstep(-0.35, 1.1, worn + 0.4 * round_off - eaten);
    float depth = 2.0 * depth_age_heat.x * share * density;

    vec3 bent = normalize(normal + 0.6 * lump.xyz);
    float wrap = clamp((dot(bent, frame.to_sun.xyz) + 0.5) / 1.5, 0.0, 1.0);
    vec3 sun = frame.sun_colour.rgb * sunlit * (0.62 * wrap + 0.22 * phase(dot(normalize(ray), frame.to_sun.xyz)));
    vec3 light = mix(dust.rgb, kSmoke, depth_age_heat.z) * (sun + ambientRadiance(mix(normal, vec3(0.0, 1.0, 0.0), 0.3)));
    light_depth = vec4(throughAir(light, at) * depth, depth);
}
