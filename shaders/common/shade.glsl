// SPDX-License-Identifier: Apache-2.0
// Light on one surface point: sun with shadow, and the sky with its occlusion.
#include "common/gbuffer.glsl"
#include "common/sky.glsl"
#include "common/brdf.glsl"
#include "common/shadow.glsl"
#ifdef GLASS
#include "common/glass_tint.glsl"
#else
vec3 throughGlass(vec3 position) { return vec3(1.0); }
#endif

// A crevice hides part of the sun's wide disc as well, so direct light is darkened a little too.
const float kDirectShare = 0.3;

#ifdef SHADOW_DRAFT
const float kFootHeight = 0.06;  // of the scene's radius

// In place of the occlusion pass: what is low and faces sideways or down sees floor that it shades itself.
float visibilityNearFloor(Surface s) {
    float below = 0.5 - 0.5 * s.geometric_normal.y;
    float height = s.position.y / (kFootHeight * frame.scene.w);
    return 1.0 - frame.floor_colour.w * 0.8 * below * (1.0 - smoothstep(0.0, 1.0, height));
}
#endif

// Neighbours that hide the sky send on what falls on them, the more the paler they are; they are taken to be of the same
// albedo (fit of Jimenez and others 2016).
vec3 openTo(float visibility, vec3 albedo) {
    vec3 a = 2.0404 * albedo - 0.3324, b = 0.6417 - 4.7951 * albedo, c = 2.7552 * albedo + 0.6903;
    return max(vec3(visibility), ((visibility * a + b) * visibility + c) * visibility);
}

// `visibility`: share of the sky that neighbours leave open, 0..1.
vec3 shade(Surface s, float visibility, vec2 pixel) {
#ifdef SHADOW_DRAFT
    visibility *= visibilityNearFloor(s);
#endif
    vec3 to_eye = normalize(frame.eye.xyz - s.position);
    float n_dot_v = max(dot(s.normal, to_eye), 0.02);
#ifdef GLOW
    visibility *= s.glow.a;
    vec3 sent_out = s.glow.rgb;
#else
    const vec3 sent_out = vec3(0.0);
#endif
    // Nothing solid is as dark as 2 %: such an albedo is a crack, which mirrors nothing either.
    float mirror_share = 0.04 * smoothstep(0.004, 0.02, max(s.albedo.r, max(s.albedo.g, s.albedo.b)));
    vec3 f0 = mix(vec3(mirror_share), s.albedo, s.metalness);
    vec3 diffuse = s.albedo * (1.0 - s.metalness);

    vec3 direct = vec3(0.0);
    float n_dot_l = dot(s.normal, frame.to_sun.xyz);
    if (n_dot_l > 0.0) {
        vec3 visible = sunVisibility(s.position, s.geometric_normal, pixel) * throughGlass(s.position);
        vec3 half_way = normalize(to_eye + frame.to_sun.xyz);
        float n_dot_h = max(dot(s.normal, half_way), 0.0);
        float l_dot_h = max(dot(to_eye, half_way), 0.0);
        vec3 mirror = fresnel(f0, l_dot_h) * ggxSpecular(n_dot_h, n_dot_v, n_dot_l, max(s.roughness, 0.06));
        vec3 scattered = diffuse * roughScattering(n_dot_l, n_dot_v, l_dot_h, s.roughness);
        direct = (scattered / 3.14159265 + mirror) * n_dot_l * visible * frame.sun_colour.rgb * 3.14159265;
    }
    vec3 share = environmentShare(f0, s.roughness, n_dot_v);
    vec3 around = ambientRadiance(s.normal);
    vec3 mirrored_light = reflectedRadiance(mainMirrored(s.normal, to_eye, s.roughness), s.roughness, around);
    vec3 scattered_light = (1.0 - share) * diffuse * around * openTo(visibility, s.albedo);
    return direct * mix(1.0, visibility, kDirectShare) + scattered_light + share * mirrored_light * visibility + sent_out;
}

#if FLOOR == FLOOR_SHADOW
// Share of its light that reaches a white floor in spite of what stands on it.
vec3 lightLeft(Surface s, float visibility, vec2 pixel) {
    vec3 sun = frame.sun_colour.rgb * max(frame.to_sun.y, 0.0), around = ambientRadiance(s.normal);
    vec3 lit = sunVisibility(s.position, s.geometric_normal, pixel) * throughGlass(s.position) * mix(1.0, visibility, kDirectShare);
    return (sun * lit + around * visibility) / max(sun + around, 1e-4);
}
#endif
