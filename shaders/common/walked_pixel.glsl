// SPDX-License-Identifier: Apache-2.0
// Walks each ray through the peeled faces of transparent bodies: at a face part of the light is mirrored and the rest is bent,
// between two it is absorbed. What the last direction meets is answered by the scene itself: floor, colliders and surroundings
// as functions, and the lit picture where something drawn lies there. What lies beyond the last peeled face counts as seen.
#define SHADOW_DRAFT
#include "common/choices.glsl"
#include "common/frame.glsl"
#include "common/shade.glsl"
#include "common/floor.glsl"
#include "common/seen.glsl"
#include "common/finish.glsl"
#ifdef COLLIDERS
#include "common/collider_surface.glsl"
#endif
#undef SHADOW_DRAFT
#ifdef DRAFT
#define SHADOW_DRAFT
#endif
#include "common/dust_over.glsl"
#include "common/peeled_faces.glsl"
#if SAMPLES > 1
layout(binding = 7) uniform sampler2DMS opaque_depth;
#else
layout(binding = 7) uniform sampler2D opaque_depth;
#endif
layout(binding = 15) uniform sampler2D picture;  // light of all that is opaque, times alpha, and alpha
layout(location = 1) uniform float frost;        // share that a broken face scatters

const float kSmooth = 0.05, kBroken = 0.22;  // roughness
const float kBrightest = 12.0;               // of the sun in a face
const float kTouches = 1e-4;                 // of the way from the eye: a face that lies in the floor is before it
const float kDetour = 2.5;                   // of light that is mirrored inside, in chords
const float kShadedHeight = 4.0;             // chords

// Of unpolarised light; `eta`: index behind the face over that before it.
float mirrors(float cosine, float eta) {
    float g2 = eta * eta - 1.0 + cosine * cosine;
    if (g2 <= 0.0) return 1.0;
    float g = sqrt(g2), a = (g - cosine) / (g + cosine), b = (cosine * (g + cosine) - 1.0) / (cosine * (g - cosine) + 1.0);
    return 0.5 * a * a * (1.0 + b * b);
}

vec4 floorSeen(vec3 from, vec3 way, vec2 pixel) {
    vec3 at = from - from.y / way.y * way, to = at - frame.eye.xyz;
    at.y = 0.0;
    // As long as rayThrough() has it: only its footprint counts.
    vec3 ray = to / max(dot(to, normalize(cross(frame.ray_up.xyz, frame.ray_right.xyz))), 0.2 * length(to));
    if (ray.y > -1e-4) ray.y = -1e-4;
    Surface s = floorSurface(at, ray);
#if FLOOR == FLOOR_SHADOW
    return shadowOver(way, lightLeft(s, 1.0, pixel));
#else
    return vec4(throughAir(shade(s, 1.0, pixel), at), 1.0);
#endif
}

// Drawn things that the picture shows where a ray leads. `reach`: m, a guess of how far they are.
bool drawnSeen(vec3 from, vec3 way, float reach, out vec4 light) {
    vec4 clip = frame.view_projection * vec4(from + reach * way, 1.0);
    vec2 at = 0.5 + 0.5 * clip.xy / clip.w;
    if (clip.w <= 0.0 || any(lessThan(at, vec2(0.0))) || any(greaterThanEqual(at, vec2(1.0)))) return false;
    float depth = texelFetch(opaque_depth, ivec2(at * frame.viewport.xy), 0).r;
    light = textureLod(picture, at, 0.0);
    return depth > 0.0 && linearDepth(depth) > dot(from - frame.eye.xyz, normalize(cross(frame.ray_up.xyz, frame.ray_right.xyz)));
}

// What a ray from a point meets: premultiplied light and alpha.
vec4 sceneSeen(vec3 from, vec3 way, float reach, vec2 pixel) {
    vec4 light;
    if (drawnSeen(from, way, reach, light)) return light;
    bool to_floor = frame.floor_colour.w > 0.0 && from.y > -kTouches * length(from - frame.eye.xyz) && way.y < -1e-3 && frame.eye.y > 0.0;
#ifdef COLLIDERS
    Crossing solid = firstCollider(from, way);
    if (solid.enter < kNoCollider && (!to_floor || solid.enter < -from.y / way.y)) {
        vec3 at = from + solid.enter * way;
        Surface s = shapeSurface(at, solid.normal, solid.solid, length(at - frame.eye.xyz));
        return vec4(throughAir(shade(s, 1.0, pixel), at), 1.0);
    }
#endif
    return to_floor ? floorSeen(from, way, pixel) : nothingSeen(way);
}

// A ray on its way.
struct Walk {
    vec3 at, way;
    vec3 light, left;  // gathered so far; share of what is to come
};

void enter(inout Walk w, vec3 n, bool broken) {
    float cosine = max(-dot(n, w.way), 0.02), f = mirrors(cosine, frame.glass.w), n_dot_l = max(dot(n, frame.to_sun.xyz), 0.0);
    float roughness = broken ? kBroken : kSmooth;
    vec3 half_way = normalize(frame.to_sun.xyz - w.way + vec3(0.0, 1e-6, 0.0));
    float glint = f * ggxSpecular(max(dot(n, half_way), 0.0), cosine, n_dot_l, roughness) * n_dot_l * 3.14159265;
    w.light += w.left * (min(glint, kBrightest) * frame.sun_colour.rgb + f * reflectedRadiance(reflect(w.way, n), roughness));
    if (broken) {
        w.light += w.left * frost * (ambientRadiance(n) + frame.sun_colour.rgb * n_dot_l) * exp(-0.02 * frame.glass.rgb * frame.scene.w);
        w.left *= 1.0 - frost;
    }
    w.left *= 1.0 - f;
    w.way = refract(w.way, n, 1.0 / frame.glass.w);
}

// A bent ray leaves a round body elsewhere than the straight one, on which its faces were found: there, as if the ball that
// has both faces. `back`: normal of the second one, out of the body; `chord`: m between them.
void bendInside(inout Walk w, inout vec3 back, inout float chord, vec3 straight) {
    // By the law of refraction, of a ray that came straight; behind other glass it is a guess.
    vec3 front = normalize(straight - frame.glass.w * w.way);
    float slant = dot(front, straight), steep = -dot(front, w.way);
    // 1 where both faces slant away from the ray alike, as those of a ball; 0 for a wall.
    float share = clamp((dot(front, back) - slant * dot(straight, back)) / max(1.0 - slant * slant, 1e-4), 0.0, 1.0);
    float bent_chord = chord * clamp(-steep / min(slant, -0.05), 1.0, 4.0);
    w.at += share * (bent_chord * w.way - chord * straight);
    chord = mix(chord, bent_chord, share);
    back = normalize(mix(back, front + 2.0 * steep * w.way, share));
}

// A body shades the floor below it, the more the thicker it is: share of the floor's light that meets a ray going down in it.
float openBelow(vec3 at, vec3 way, float chord) {
    float near = 1.0 - smoothstep(0.0, kShadedHeight, at.y / max(chord, 1e-6));
    return 1.0 - frame.floor_colour.w * 0.85 * smoothstep(-0.1, 0.5, -way.y) * near;
}

// `chord`: m inside, up to here.
void leave(inout Walk w, vec3 n, bool broken, vec3 straight, float chord) {
    vec3 out_of = refract(w.way, n, frame.glass.w);
    bool total = dot(out_of, out_of) < 0.5;
    float f = min(mirrors(max(-dot(n, w.way), 0.02), 1.0 / frame.glass.w), 0.92);
    // What is mirrored inside is mirrored again before it comes out somewhere else: it has a longer way than the ray had.
    vec3 inside = exp(-kDetour * chord * frame.glass.rgb), turned = reflect(w.way, n);
    vec3 met = reflectedRadiance(turned, broken ? kBroken : kSmooth);
    w.light += w.left * f * inside * openBelow(w.at, turned, chord) * met;
    if (broken) {
        w.light += w.left * frost * (ambientRadiance(-n) + 0.5 * frame.sun_colour.rgb * max(-dot(n, frame.to_sun.xyz), 0.0));
        w.left *= 1.0 - frost;
    }
    w.left *= 1.0 - f;
    w.way = total ? normalize(mix(w.way, straight, 0.5)) : normalize(out_of);
}

// Along the view axis, m, to what is opaque.
float opaqueAlong(ivec2 pixel, vec3 ray) {
    float depth = texelFetch(opaque_depth, pixel, 0).r, along = min(depth > 0.0 ? linearDepth(depth) : kNoFloor, floorAlong(ray));
#ifdef COLLIDERS
    along = min(along, nearestCollider(ray).enter);
#endif
    return along;
}

vec4 walked(ivec2 at, ivec2 pixel) {
    vec3 ray = rayThrough((vec2(at) + 0.5) / float(ACROSS)), straight = normalize(ray);
    float end = opaqueAlong(pixel, ray), last = 0.0;
    Walk w = Walk(frame.eye.xyz, straight, vec3(0.0), vec3(1.0));
    bool inside = false;
    // Fetched before the loop: after one that all pixels leave at once, a software renderer fetches for one of eight.
    vec4 behind = texelFetch(picture, pixel, 0);
    float nearer = 2.0;
    for (int k = 0, met = 0; k < kFaces && met < LAYERS; ++k) {
        float depth = faceDepth(at, k), along = linearDepth(depth);
        if (depth == 0.0 || along > (1.0 + kTouches) * end) break;
        if (!isBehind(depth, nearer)) continue;
        GlassLayer layer = faceOf(at, k, ray);
        nearer = depth;
        ++met;
        float chord = inside ? (along - last) * length(ray) : 0.0;
        last = along;
        w.at = frame.eye.xyz + ray * along;
        if (layer.curved && !layer.enters) bendInside(w, layer.normal, chord, straight);
        w.left *= exp(-frame.glass.rgb * chord);
        vec3 n = layer.enters ? layer.normal : -layer.normal;  // against the ray
        float away = dot(n, w.way);
        if (away > -0.02) n = normalize(n - (away + 0.02) * w.way);
        if (layer.enters) enter(w, n, layer.broken);
        else leave(w, n, layer.broken, straight, chord);
        inside = layer.enters;
    }
    if (last == 0.0) return behind;
    if (inside && end < kNoFloor) w.left *= exp(-frame.glass.rgb * max(end - last, 0.0) * length(ray));  // it goes on below
    vec4 seen = sceneSeen(w.at, w.way, end < kNoFloor ? (end - last) * length(ray) : frame.scene.w, vec2(pixel));
    vec3 light = w.light + w.left * seen.rgb;
    float mean_left = dot(w.left, vec3(1.0 / 3.0));
#ifdef TRANSPARENT
    return vec4(light, clamp(max(1.0 - mean_left * (1.0 - seen.a), max(w.light.r, max(w.light.g, w.light.b))), 0.0, 1.0));
#else
    return vec4(light, 1.0);
#endif
}

vec4 pixelWalked(ivec2 pixel) {
    vec4 dust = dustBefore(pixel), sum = vec4(0.0);
    for (int i = 0; i < ACROSS * ACROSS; ++i) {
        ivec2 at = ACROSS * pixel + ivec2(i % ACROSS, i / ACROSS);
        sum += taken(dust + (1.0 - dust.a) * walked(at, pixel));
        forgetFaces(at);
    }
    return finished(sum / float(ACROSS * ACROSS));
}
