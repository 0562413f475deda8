#version 450 core
// Half-size linear depth: the nearest of four pixels, so that thin things keep their outline.
layout(local_size_x = 8, local_size_y = 8) in;
#include "common/frame.glsl"
#ifdef MULTISAMPLE
layout(binding = 0) uniform sampler2DMS depth_buffer;
#else
layout(binding = 0) uniform sampler2D depth_buffer;
#endif
layout(r32f, binding = 0) writeonly uniform image2D result;

void main() {
    ivec2 p = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(p, imageSize(result)))) return;
    ivec2 last = ivec2(frame.viewport.xy) - 1;
    float nearest = 0.0;  // reversed: larger is nearer
    for (int k = 0; k < 4; ++k) {
        ivec2 pixel = min(2 * p + ivec2(k & 1, k >> 1), last);
        nearest = max(nearest, texelFetch(depth_buffer, pixel, 0).r);
    }
    imageStore(result, p, vec4(linearDepth(nearest)));
}
