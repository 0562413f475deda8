// SPDX-License-Identifier: Apache-2.0
// Projectiles as rays meet them.
#include "common/ball_material.glsl"
struct Ball {
    vec4 position_radius;  // m
    uvec4 unused;
};
layout(std430, binding = 10) readonly buffer Balls { Ball balls[]; };

// Where a ray from the eye meets a ball, in lengths of the ray; negative: it does not.
float ballAlong(vec4 ball, vec3 ray) {
    vec3 to_centre = ball.xyz - frame.eye.xyz;
    float length_2 = dot(ray, ray), nearest = dot(to_centre, ray) / length_2;
    vec3 beside = to_centre - nearest * ray;
    float inside = ball.w * ball.w - dot(beside, beside);
    return inside >= 0.0 ? nearest - sqrt(inside / length_2) : -1.0;
}
