// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Empties the sums of caustics_cast.comp, for the next frame.
layout(local_size_x = 64) in;
#include "common/caustics.glsl"

void main() { caustics[gl_GlobalInvocationID.x] = ivec4(0); }
