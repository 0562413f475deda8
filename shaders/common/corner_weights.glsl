// SPDX-License-Identifier: Apache-2.0
// Where a ray from the eye meets a triangle of the body (common/body_triangle.glsl).

// A triangle in the world.
struct Corners {
    vec3 first, to_1, to_2;  // m
};

Corners cornersIn(BodyVertex v[3], FragmentTransform t) {
    vec3 first = moved(t, v[0].rest);
    return Corners(first, moved(t, v[1].rest) - first, moved(t, v[2].rest) - first);
}

// Weights of the second and third corner where a ray from the eye meets the triangle's plane.
vec2 weightsAt(Corners c, vec3 ray) {
    vec3 from = frame.eye.xyz - c.first, across = cross(ray, c.to_2);
    float area = dot(c.to_1, across);
    return vec2(dot(from, across), dot(ray, cross(from, c.to_1))) / (abs(area) > 1e-30 ? area : 1e-30);
}

// The nearest weights that are inside.
vec3 nearestInside(vec2 w) {
    vec3 weights = max(vec3(1.0 - w.x - w.y, w), 0.0);
    return weights / (weights.x + weights.y + weights.z);
}
