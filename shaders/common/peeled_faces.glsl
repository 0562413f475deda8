// SPDX-License-Identifier: Apache-2.0
// The k-th face of transparent bodies along a ray, as it was drawn (layers) or found by computing (FOUND_FACES). `at`: in a
// picture ACROSS times as wide.
#include "common/glass_layer.glsl"
#ifdef FOUND_FACES
#include "common/body_triangle.glsl"
#include "common/corner_weights.glsl"
#include "common/faces.glsl"
#define GLASS_NOISE 20
#include "common/glass_relief.glsl"

const int kFaces = KEPT;

float faceDepth(ivec2 at, int k) { return uintBitsToFloat(faces[facePlace(at, uint(k))].y); }

// `ray`: of the sample, as rayThrough().
GlassLayer faceOf(ivec2 at, int k, vec3 ray) {
    uvec2 face = faces[facePlace(at, uint(k))];
    uint name = face.x;
    BodyVertex v[3];
    fetchTriangle(name, v);
    FragmentTransform t = motionOf(v[0]);  // all corners are of one fragment
    Corners corners = cornersIn(v, t);
    vec2 w = weightsAt(corners, ray), step_size = 2.0 / float(ACROSS) * frame.viewport.zw;
    vec3 weights = nearestInside(w), even = cross(corners.to_1, corners.to_2);
    mat3 normals = mat3(decodeOctahedral(unpackSnorm2x16(v[0].normal)), decodeOctahedral(unpackSnorm2x16(v[1].normal)),
                        decodeOctahedral(unpackSnorm2x16(v[2].normal)));
    GlassLayer layer = GlassLayer(uintBitsToFloat(face.y), normalize(rotate(t.rotation, normals * weights)),
                                  dot(even, frame.eye.xyz - corners.first) > 0.0, isInterior(name), false);
    if (!layer.broken) {
        layer.curved = v[1].normal != v[0].normal || v[2].normal != v[0].normal;
        return layer;
    }
    vec3 rest = mat3(v[0].rest, v[1].rest, v[2].rest) * weights;
    mat2x3 edges = mat2x3(v[1].rest - v[0].rest, v[2].rest - v[0].rest);
    noise_footprint = max(length(edges * (weightsAt(corners, ray + step_size.x * frame.ray_right.xyz) - w)),
                          length(edges * (weightsAt(corners, ray + step_size.y * frame.ray_up.xyz) - w)));
    layer.normal = brokenNormal(layer.normal, even, rest, t.rotation);
    return layer;
}

// The next frame finds the ray as empty as it was.
void forgetFaces(ivec2 at) {
    for (uint k = 0u; k < uint(KEPT) && faces[facePlace(at, k)].y != 0u; ++k) faces[facePlace(at, k)] = uvec2(0u);
}
#else
layout(binding = 3) uniform usampler2D layers[LAYERS];

const int kFaces = LAYERS;

float faceDepth(ivec2 at, int k) { return uintBitsToFloat(texelFetch(layers[k], at, 0).r); }

GlassLayer faceOf(ivec2 at, int k, vec3 ray) { return unpackLayer(texelFetch(layers[k], at, 0).rg); }

void forgetFaces(ivec2 at) {}
#endif
