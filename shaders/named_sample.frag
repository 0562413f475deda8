// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One of each pixel's samples: the material of the small triangle there, if there is one (engine/passes/named_pass.h).
layout(binding = 3) uniform usampler2D samples;  // r: record, from 1 on; g: depth, as bits; those of a pixel beside each other
layout(binding = 4) uniform sampler2D materials;  // of the records, as common/gbuffer.glsl packs them
layout(binding = 5) uniform sampler2D normals;
layout(location = 1) uniform ivec2 which;  // x: sample, y: samples of a pixel
layout(location = 0) out vec4 material_out;
layout(location = 1) out vec4 normals_out;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uvec2 found = texelFetch(samples, ivec2(which.y * pixel.x + which.x, pixel.y), 0).rg;
    if (found.r == 0u) discard;
    uint across = uint(textureSize(materials, 0).x);
    ivec2 record = ivec2((found.r - 1u) % across, (found.r - 1u) / across);
    material_out = texelFetch(materials, record, 0);
    normals_out = texelFetch(normals, record, 0);
    gl_FragDepth = uintBitsToFloat(found.g);
    gl_SampleMask[0] = 1 << which.x;
}
