// SPDX-License-Identifier: Apache-2.0
#version 450 core
// One picture of linear light onto the sum of those before (blended).
layout(binding = 0) uniform sampler2D picture;
layout(location = 0) out vec4 light;

void main() {
    light = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
