// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Colliders into the shadow map; rows of work groups: a collider in a region.
layout(local_size_x = 64) in;
#include "common/frame.glsl"
#include "common/colliders.glsl"
#include "common/put_shadow.glsl"

void main() {
    Collider c = colliders[gl_WorkGroupID.y];
    int region = int(gl_WorkGroupID.z);
    mat4 to_map = frame.light_matrix[region], from_map = inverse(to_map);
    vec2 centre = (to_map * vec4(c.centre.xyz, 1.0)).xy, reach = vec2(0.0);
    for (int k = 0; k < 3; ++k) reach += abs(mat3(to_map) * (c.axis[k].w * c.axis[k].xyz)).xy;
    float texels = float(shadow_texels);
    ivec2 low = max(ivec2(floor((centre - reach) * texels)), ivec2(0));
    ivec2 size = min(ivec2(ceil((centre + reach) * texels)), ivec2(shadow_texels - 1)) - low + 1;
    if (any(lessThanEqual(size, ivec2(0)))) return;
    int lanes = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int k = int(gl_GlobalInvocationID.x); k < size.x * size.y; k += lanes) {
        ivec2 texel = low + ivec2(k % size.x, k / size.x);
        vec3 p = (from_map * vec4((vec2(texel) + 0.5) / texels, 0.5, 1.0)).xyz, caster;
        if (shadowPoint(gl_WorkGroupID.y, p, caster)) putShadow(texel, region, (to_map * vec4(caster, 1.0)).z);
    }
}
