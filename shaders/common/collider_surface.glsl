// SPDX-License-Identifier: Apache-2.0
// Colliders are rendered walls, of the floor's colour or their own, with stains, the strokes of the trowel and a grain that bends
// the light.
#include "common/colliders.glsl"
#include "common/fine_grain.glsl"
#include "common/stone.glsl"

// xyz: gradient along the surface, w: value, of noise whose cells are `size` (m); `footprint`: of a pixel, m.
vec4 wallNoise(vec3 position, vec3 size, float footprint) {
    return noiseOver(position / size, footprint / min(size.x, min(size.y, size.z)));
}

// Edges of a box are worn: within a rim the normal leans over them, and the stone is lighter there, here more and there less.
// xyz: to add to a unit normal; w: 0 to 1, on an edge. Other shapes have none.
vec4 wornEdge(uint solid, vec3 position, vec3 normal, float footprint) {
    Collider c = colliders[solid];
    vec4 edge = vec4(0.0);
    if (c.centre.w != kBox) return edge;
    float least = min(c.axis[0].w, min(c.axis[1].w, c.axis[2].w)), size = frame.eye.w;
    float rim = min(0.02 * size, 0.12 * least) * (1.0 + 0.6 * wallNoise(position, vec3(0.07 * size), footprint).w);
    for (int k = 0; k < 3; ++k) {
        vec3 axis = c.axis[k].xyz;
        float at = dot(position - c.centre.xyz, axis), over = abs(at) - (c.axis[k].w - rim);
        if (over <= 0.0 || abs(dot(normal, axis)) > 0.7) continue;
        float share = clamp(over / max(rim, 0.5 * footprint), 0.0, 1.0);
        edge += vec4(sign(at) * share * axis, share * share);
    }
    return vec4(edge.xyz, min(edge.w, 1.0));
}

// `colour`: as Collider has it. `along`: m, from the eye along the view axis.
Surface colliderSurface(vec3 position, vec3 normal, vec4 colour, float along) {
    float facing = max(abs(dot(normal, normalize(frame.eye.xyz - position))), 0.05);
    float footprint = 2.0 * frame.viewport.w * frame.depth_range.z * along / facing, size = frame.eye.w;
    float wide = wallNoise(position, vec3(1.9 * size), footprint).w;
    vec4 cloud = wallNoise(position, vec3(0.5 * size), footprint);
    vec4 stroke = wallNoise(kTurn1 * position, vec3(0.7, 0.2, 0.7) * size, footprint);
    Surface s;
    s.position = position;
    s.geometric_normal = normal;
    s.normal = normal;
    float tone = 1.0 + 0.12 * wide + 0.09 * cloud.w + 0.07 * stroke.w;
    if (kFineGrain) {
        vec4 grain = wallNoise(kTurn2 * position, vec3(0.03 * size), footprint);
        vec3 slope = 0.02 * cloud.xyz + transpose(kTurn1) * (0.03 * stroke.xyz) + transpose(kTurn2) * (0.035 * grain.xyz);
        s.normal = normalize(normal - (slope - normal * dot(normal, slope)));
        tone *= 1.0 + 0.06 * grain.w;
    }
    s.albedo = min(mix(frame.floor_colour.rgb, colour.rgb, colour.a) * tone, 1.0);
    s.roughness = stoneRoughness(cloud.w);
    s.metalness = 0.0;
    return s;
}

// Of a shape; `solid`: its number.
Surface shapeSurface(vec3 position, vec3 normal, uint solid, float along) {
    Surface s = colliderSurface(position, normal, colliders[solid].colour, along);
    vec4 edge = wornEdge(solid, position, normal, 2.0 * frame.viewport.w * frame.depth_range.z * along);
    s.normal = normalize(s.normal + edge.xyz);
    s.albedo = min(s.albedo * (1.0 + 0.22 * edge.w), 1.0);
    return s;
}
