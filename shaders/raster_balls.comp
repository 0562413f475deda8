// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Projectiles into the pictures of a frame (common/raster.glsl); rows of work groups: a ball in a view.
layout(local_size_x = 64) in;
#include "common/raster.glsl"
#include "common/ball.glsl"

// Box of the pixels that a disc touches.
struct Box { ivec2 low, high; };

Box boxRound(vec2 centre, float radius, ivec2 size) {
    return Box(max(ivec2(floor(centre - radius)), ivec2(0)), min(ivec2(ceil(centre + radius)), size - 1));
}

// Does the ball lie beyond one of the planes through the eye that bound the picture, or behind it?
bool isBesidePicture(vec4 ball) {
    vec3 centre = (frame.view * vec4(ball.xyz, 1.0)).xyz;
    vec2 slope = frame.depth_range.z * vec2(frame.depth_range.w, 1.0);
    vec2 beyond = (abs(centre.xy) + centre.z * slope) / sqrt(1.0 + slope * slope);
    return max(beyond.x, beyond.y) > 1.01 * ball.w || centre.z > ball.w;
}

Box cameraBox(vec4 ball) {
    ivec2 size = ivec2(frame.viewport.xy);
    if (isBesidePicture(ball)) return Box(ivec2(0), ivec2(-1));
    vec4 clip = frame.view_projection * vec4(ball.xyz, 1.0);
    float nearest = clip.w - 1.01 * ball.w;
    if (nearest <= frame.depth_range.x) return Box(ivec2(0), size - 1);
    vec2 centre = (clip.xy / clip.w * 0.5 + 0.5) * frame.viewport.xy;
    // Off the axis the outline is longer than across it.
    vec2 slope = clip.xy / clip.w * vec2(frame.depth_range.w, 1.0) * frame.depth_range.z;
    float radius = 0.5 * frame.viewport.y / frame.depth_range.z * ball.w / nearest * sqrt(1.0 + dot(slope, slope));
    return boxRound(centre, 2.0 + radius * sqrt(1.0 + dot(slope, slope)), size);
}

void seeFromCamera(vec4 ball, uint name, ivec2 pixel) {
    for (int i = 0; i < SAMPLES; ++i) {
        vec3 ray = rayThrough(vec2(pixel) + vec2(sample_at[i]) / float(kGrid));
        float along = ballAlong(ball, ray);
        if (along <= 0.0) continue;
        vec4 clip = frame.view_projection * vec4(frame.eye.xyz + along * ray, 1.0);
        precise float depth = clip.z / clip.w;
        if (depth <= 0.0 || depth > 1.0) continue;
        uint place = sampleIndex(pixel, SAMPLES, i);
        putSample(place, floatBitsToUint(depth), name, depthOfSample(place));
    }
}

// Half way to the middle: casts the same shadow, and the lit side keeps clear of it.
void seeFromSun(vec3 centre, vec2 radius, ivec2 pixel, int region) {
    vec2 on_disc = (vec2(pixel) + 0.5 - centre.xy) / radius.x;
    float inside = 1.0 - dot(on_disc, on_disc);
    if (inside >= 0.0) putShadow(pixel, region, centre.z - 0.6 * radius.y * sqrt(inside));
}

void main() {
    vec4 ball = balls[gl_WorkGroupID.y].position_radius;
    int view = int(gl_WorkGroupID.z);
    vec3 centre = vec3(0.0);
    vec2 radius = vec2(0.0);
    Box box;
    if (view == kCamera) {
        box = cameraBox(ball);
    } else {
        centre = (frame.light_matrix[view - 1] * vec4(ball.xyz, 1.0)).xyz * vec3(vec2(shadow_texels), 1.0);
        radius = ball.w / vec2(frame.shadow[view - 1].x, frame.shadow[view - 1].w);
        box = boxRound(centre.xy, radius.x, ivec2(shadow_texels));
    }
    ivec2 size = box.high - box.low + 1;
    if (any(lessThanEqual(size, ivec2(0)))) return;
    int lanes = int(gl_NumWorkGroups.x * gl_WorkGroupSize.x);
    for (int k = int(gl_GlobalInvocationID.x); k < size.x * size.y; k += lanes) {
        ivec2 pixel = box.low + ivec2(k % size.x, k / size.x);
        if (view == kCamera) seeFromCamera(ball, kSphereBits | gl_WorkGroupID.y, pixel);
        else seeFromSun(centre, radius, pixel, view - 1);
    }
}
