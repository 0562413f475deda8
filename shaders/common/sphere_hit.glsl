// SPDX-License-Identifier: Apache-2.0
// Where the ray through this fragment meets the sphere.
in vec3 on_square;            // world, m
flat in vec4 centre_radius;
flat in float value;
flat in uint fragment_slot;

// How far the ray passes inside the outline, in units of the radius squared; negative: it misses.
float sphereDepth(vec3 ray) {
    vec3 to_centre = centre_radius.xyz - frame.eye.xyz;
    vec3 beside = to_centre - ray * dot(to_centre, ray);
    return 1.0 - dot(beside, beside) / (centre_radius.w * centre_radius.w);
}

vec3 sphereHit(vec3 ray, float inside) {
    float along = dot(centre_radius.xyz - frame.eye.xyz, ray);
    return frame.eye.xyz + ray * (along - centre_radius.w * sqrt(max(inside, 0.0)));
}

float clipDepth(vec3 position) {
    vec4 clip = frame.view_projection * vec4(position, 1.0);
    return clip.z / clip.w;
}
