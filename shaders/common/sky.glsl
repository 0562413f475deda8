// SPDX-License-Identifier: Apache-2.0
// The surroundings: their radiance in a direction, the light they send onto a surface together with the
// floor, and what rough surfaces mirror of them. The C++ side is engine/surroundings/surroundings.h.
layout(binding = 8) uniform sampler2D backdrop;  // octahedral
layout(binding = 9) uniform sampler3D mirrored;  // octahedral, roughness along w
layout(binding = 10) uniform sampler2D horizon;

// Place in an octahedral map with a border of a texel.
vec2 octahedralPlace(vec3 direction, float side) { return 0.5 + 0.5 * (side - 2.0) / side * encodeOctahedral(direction); }

vec3 backdropRadiance(vec3 direction) {
    return textureLod(backdrop, octahedralPlace(direction, float(textureSize(backdrop, 0).x)), 0.0).rgb;
}

// Mean radiance over the hemisphere about `n` (irradiance / pi).
vec3 harmonicsAt(vec3 n) {
    return frame.harmonics[0].rgb + frame.harmonics[1].rgb * n.y + frame.harmonics[2].rgb * n.z +
           frame.harmonics[3].rgb * n.x + frame.harmonics[4].rgb * (n.x * n.y) +
           frame.harmonics[5].rgb * (n.y * n.z) + frame.harmonics[6].rgb * (3.0 * n.z * n.z - 1.0) +
           frame.harmonics[7].rgb * (n.x * n.z) + frame.harmonics[8].rgb * (n.x * n.x - n.y * n.y);
}

vec3 ambientRadiance(vec3 n) {
    return max(harmonicsAt(n), 0.0) + frame.floor_bounce.rgb * (0.5 - 0.5 * n.y);
}

vec3 mirroredLayer(vec3 direction, float roughness) {
    vec3 size = vec3(textureSize(mirrored, 0));
    float layer = (roughness * (size.z - 1.0) + 0.5) / size.z;
    return textureLod(mirrored, vec3(octahedralPlace(direction, size.x), layer), 0.0).rgb;
}

// The ground of a picture is not the scene's.
vec3 aboveFloor(vec3 direction) {
    return frame.floor_colour.w > 0.0 ? vec3(direction.x, max(direction.y, 0.0), direction.z) : direction;
}
vec3 floorBelow(vec3 mirrored_sky, vec3 direction, float roughness) {
    float blend = smoothstep(-0.08 - 0.5 * roughness, 0.08 + 0.5 * roughness, direction.y);
    return mix(frame.floor_bounce.rgb, mirrored_sky, mix(1.0, blend, frame.floor_colour.w));
}

// What a surface of the given roughness mirrors: the surroundings, and the floor where there is one.
vec3 reflectedRadiance(vec3 direction, float roughness) {
    return floorBelow(mirroredLayer(aboveFloor(direction), roughness), direction, roughness);
}

const float kRoughest = 0.6;

// The same of what may be rough. `ambient`: what it scatters, that is ambientRadiance() of its normal.
vec3 reflectedRadiance(vec3 direction, float roughness, vec3 ambient) {
#ifdef SHADOW_DRAFT
    // Rough things mirror hardly more than they scatter. A loop in place of a branch, which software renderers go through
    // also where no pixel takes it.
    vec3 mirrored_sky = ambient;
    for (bool smoother = roughness < kRoughest; smoother; smoother = false) {
        vec3 layer = mirroredLayer(aboveFloor(direction), roughness);
        mirrored_sky = mix(layer, ambient, smoothstep(kRoughest - 0.1, kRoughest, roughness));
    }
    return floorBelow(mirrored_sky, direction, roughness);
#else
    return reflectedRadiance(direction, roughness);
#endif
}

#if FLOOR == FLOOR_SWEEP
// The paper goes on upwards behind the scene and gets darker there.
vec3 sweepRadiance(vec3 direction) {
    vec3 light = frame.sun_colour.rgb * max(frame.to_sun.y, 0.0) + ambientRadiance(vec3(0.0, 1.0, 0.0));
    return frame.floor_colour.rgb * light * mix(1.0, 0.45, smoothstep(-0.15, 0.7, direction.y));
}
vec3 skyRadiance(vec3 direction) {
    return sweepRadiance(direction);
}
vec3 horizonRadiance(vec3 ray) {
    return sweepRadiance(normalize(ray));
}
float airReach(float distance) { return 3.0 * frame.scene.w + 2.0 * distance; }
#else
vec3 skyRadiance(vec3 direction) {
    return backdropRadiance(direction);
}
vec3 horizonRadiance(vec3 ray) {
    float x = ray.x / max(abs(ray.x) + abs(ray.z), 1e-9);
    return textureLod(horizon, vec2(0.25 * (ray.z >= 0.0 ? 1.0 - x : 3.0 + x), 0.5), 0.0).rgb;
}
// Far enough that air does not veil the scene nor the floor about it, and near enough that the floor is gone
// before it ends.
float airReach(float distance) {
    float clear = 20.0 * frame.scene.w + 6.0 * distance, ends = kFloorReach * frame.depth_range.y;
    return max(min(clear, 0.45 * ends), 2.0 * distance);
}
#endif

// Air between the eye and a point: far things fade into the haze of the horizon. It hardly begins before half
// its reach, as air close by takes nothing away.
vec3 throughAir(vec3 colour, vec3 position) {
    vec3 ray = position - frame.eye.xyz;
    float reach = airReach(length(frame.eye.xyz - frame.scene.xyz));
    float haze = 1.0 - exp(-dot(ray, ray) / (reach * reach));
    return mix(colour, horizonRadiance(ray), haze);
}
