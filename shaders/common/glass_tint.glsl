// SPDX-License-Identifier: Apache-2.0
// What transparent bodies leave of the sun.
layout(binding = 14) uniform sampler2D glass_shadow;  // m inside of bodies; -log of what their faces leave
#ifndef SHADOW_DRAFT
layout(binding = 20) uniform sampler2D caustics;  // of the floor: its light, times what is there without such bodies
const float kOnFloor = 1e-4;                      // of the scene's radius
#endif

vec3 throughGlass(vec3 position) {
    vec3 p = (frame.light_matrix[0] * vec4(position, 1.0)).xyz;
    if (any(greaterThan(abs(p.xy - 0.5), vec2(0.49)))) return vec3(1.0);
#ifndef SHADOW_DRAFT
    if (frame.floor_colour.w > 0.0 && abs(position.y) < kOnFloor * frame.scene.w)
        return 0.5 * (textureLod(caustics, p.xy, 0.0).rgb + textureLod(caustics, p.xy, 1.0).rgb);
#endif
    // Sharp where it falls and soft by what is bent a little.
    vec2 sums = 0.5 * (textureLod(glass_shadow, p.xy, 1.0).rg + textureLod(glass_shadow, p.xy, 3.0).rg);
    float inside = max(sums.r, 0.0), lost = max(sums.g, 0.0);
    // What slanting faces bend away arrives behind those that stand square to the sun.
    return exp(-frame.glass.rgb * inside - lost) * (1.0 + 0.7 * smoothstep(0.0, 0.05 * frame.scene.w, inside) * exp(-6.0 * lost));
}
