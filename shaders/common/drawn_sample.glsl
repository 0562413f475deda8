// SPDX-License-Identifier: Apache-2.0
// What a sample shows, as the drawing passes left it (common/gbuffer.glsl).
#if SAMPLES > 1
layout(binding = 3) uniform usampler2DMS material_buffer;
layout(binding = 4) uniform usampler2DMS normal_buffer;
layout(binding = 5) uniform sampler2DMS depth_buffer;
#else
layout(binding = 3) uniform usampler2D material_buffer;
layout(binding = 4) uniform usampler2D normal_buffer;
layout(binding = 5) uniform sampler2D depth_buffer;
#endif

#ifdef GLOW
#if SAMPLES > 1
layout(binding = 19) uniform sampler2DMS glow_buffer;
#else
layout(binding = 19) uniform sampler2D glow_buffer;
#endif
#endif

const bool kShowsBodies = true;

float depthAt(ivec2 pixel, int i) { return texelFetch(depth_buffer, pixel, i).r; }

// Equal for samples that look alike; nothing drawn is as smooth as 0, so x is never that of floor or sky.
uvec3 valueAt(ivec2 pixel, int i) {
    uvec3 value = uvec3(texelFetch(material_buffer, pixel, i).r, texelFetch(normal_buffer, pixel, i).rg);
#ifdef GLOW
    vec4 glow = texelFetch(glow_buffer, pixel, i);
    value.yz ^= uvec2(packHalf2x16(glow.rg), packHalf2x16(glow.ba));
#endif
    return value;
}

Surface surfaceAt(ivec2 pixel, int i, vec3 position) {
    Surface s = unpackSurface(texelFetch(material_buffer, pixel, i).r, texelFetch(normal_buffer, pixel, i).rg, position);
#ifdef GLOW
    s.glow = texelFetch(glow_buffer, pixel, i);
#endif
    return s;
}
