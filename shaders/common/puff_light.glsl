// SPDX-License-Identifier: Apache-2.0
// What a puff adds along a ray: its light times its optical depth, and the depth itself. Sums do not hang on the order.
#include "common/seen_puff.glsl"
layout(location = 0) uniform vec4 dust;  // rgb: colour; w: 1/m, of its lumps

const vec3 kSmoke = vec3(0.30, 0.29, 0.28);

// Henyey and Greenstein's, forward.
float phase(float cosine) {
    const float g = 0.45;
    float k = 1.0 + g * g - 2.0 * g * cosine;
    return (1.0 - g * g) / (k * sqrt(k));
}

// `from_middle`: of the puff, in its radii, along right and up of the picture; `solid`: m along the view axis to what the
// ray meets.
vec4 puffAlong(SeenPuff puff, vec2 from_middle, vec3 ray, float solid) {
    vec2 way = puff.along.xy;
    vec2 corner = vec2(dot(way, from_middle) / puff.place.w, dot(vec2(-way.y, way.x), from_middle) * puff.place.w);
    float d2 = dot(corner, corner);
    if (d2 >= 1.0) return vec4(0.0);
    float radius = puff.position_radius.w, bump = sqrt(1.0 - d2), age = puff.depth_age_heat_sunlit.y;
    vec3 forward = normalize(frame.ray_forward.xyz);
    float along = dot(puff.position_radius.xyz - frame.eye.xyz, forward);
    float front = max(along - radius * bump, frame.depth_range.x), end = min(along + radius * bump, solid);
    // The share of the chord in front of what is solid; nothing close to the eye.
    float share = clamp((end - front) / (2.0 * radius * bump), 0.0, 1.0) * smoothstep(0.0, 0.3, front / radius);
    if (share == 0.0) return vec4(0.0);
    vec3 across = from_middle.x * normalize(frame.ray_right.xyz) + from_middle.y * normalize(frame.ray_up.xyz);
    vec3 normal = normalize(across - bump * forward);
    vec3 at = puff.position_radius.xyz + 0.7 * radius * normal;
    // Lumps stand in the world, so that puffs which overlap wear alike; they drift upwards a little.
    vec3 q = dust.w * (at - vec3(0.0, 0.05 * age, 0.0));
    float footprint = dust.w * radius * puff.place.z;
    vec4 lump = noiseOver(q, footprint);
    vec3 curled = q + 0.3 * lump.xyz;
    float worn = 0.8 * lump.w + noiseOver(curled * 2.3 + 3.1, 2.3 * footprint).w;
#ifdef FULL
    worn += 0.6 * noiseOver(curled * 5.1, 5.1 * footprint).w;
#endif
    // Neither a rim nor a plateau, or a single puff is a disc: it thins out to nothing, and lumps wear it everywhere.
    float round_off = (1.0 - d2) * (1.0 - d2), eaten = 0.3 * min(age, 1.5);
    float density = 2.3 * round_off * smoothstep(-0.35, 1.1, worn + 0.4 * round_off - eaten);
    float depth = 2.0 * puff.depth_age_heat_sunlit.x * share * density;

    vec3 bent = normalize(normal + 0.6 * lump.xyz);
    float wrap = clamp((dot(bent, frame.to_sun.xyz) + 0.5) / 1.5, 0.0, 1.0);
    float scattered = 0.62 * wrap + 0.22 * phase(dot(normalize(ray), frame.to_sun.xyz));
    vec3 sun = frame.sun_colour.rgb * puff.depth_age_heat_sunlit.w * scattered;
    vec3 around = ambientRadiance(mix(normal, vec3(0.0, 1.0, 0.0), 0.3));
    vec3 light = mix(dust.rgb, kSmoke, puff.depth_age_heat_sunlit.z) * (sun + around);
    return vec4((puff.air.rgb + puff.air.a * light) * depth, depth);
}
