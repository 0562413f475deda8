// SPDX-License-Identifier: Apache-2.0
// What every pass of a frame knows; the C++ side is engine/render/frame_uniforms.h.
layout(std140, binding = 0) uniform Frame {
    mat4 view_projection;  // world to clip, reversed depth in 0..1
    mat4 view;             // world to view
    mat4 light_matrix[2];  // world to the near and the far region of the shadow map: u, v, depth in 0..1
    vec4 eye;              // xyz: camera, w: edge of a floor tile, m
    vec4 ray_right;        // rays through the picture: forward + x * right + y * up, x and y in -1..1
    vec4 ray_up;
    vec4 ray_forward;
    vec4 to_sun;           // xyz: unit; w: tangent of the sun's apparent radius
    vec4 sun_colour;       // rgb linear: what a white surface facing the sun shines with
    vec4 floor_colour;     // rgb; w: 1 when the floor is drawn
    vec4 floor_bounce;     // rgb: light of the floor seen from below; 0 without a floor; w: 1 when dust is seen
    vec4 exposure;         // rgb: factors, white balance included; w: turn of what differs from pixel to pixel, 0..1
    vec4 harmonics[9];     // rgb: of the light from above, and without a floor from below (common/sky.glsl)
    vec4 viewport;         // width, height, 1/width, 1/height, px
    vec4 shadow[2];        // of a region; x: m per texel, y: 1/texels, z: width in m, w: depth range in m
    vec4 to_far_scale;     // from near to far region: u, v, depth times scale, plus shift
    vec4 to_far_shift;
    vec4 depth_range;      // x: near, y: far, m; z: tan(fov_y / 2); w: aspect
    vec4 scene;            // xyz: centre, w: radius, m
    vec4 glass;            // of transparent bodies; rgb: absorption, 1/m; w: refraction index
} frame;

// How far the floor goes on from the camera along x and z, times the far plane's distance.
const float kFloorReach = 0.7;

// Distance along the view axis from reversed depth.
float linearDepth(float depth) {
    float near = frame.depth_range.x, far = frame.depth_range.y;
    return near * far / (near + depth * (far - near));
}

// Ray through a point of the picture (px), as long as one unit along the view axis.
vec3 rayThrough(vec2 pixel) {
    vec2 ndc = 2.0 * pixel * frame.viewport.zw - 1.0;
    return frame.ray_forward.xyz + ndc.x * frame.ray_right.xyz + ndc.y * frame.ray_up.xyz;
}

// A value in 0..1 for each pixel that differs most from its neighbours' (interleaved gradient noise, Jimenez 2014);
// depends on the pixel alone, so a frame is the same every time; pictures of which a film takes the mean turn it.
float pixelNoise(vec2 pixel) {
    return fract(52.9829189 * fract(dot(floor(pixel), vec2(0.06711056, 0.00583715))) + frame.exposure.w);
}
