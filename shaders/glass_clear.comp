// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Empties the layers that faces of transparent bodies are peeled into.
layout(local_size_x = 8, local_size_y = 8) in;
layout(rg32ui, binding = 0) writeonly uniform uimage2D layers[LAYERS];

void main() {
    ivec2 at = ivec2(gl_GlobalInvocationID.xy);
    if (any(greaterThanEqual(at, imageSize(layers[0])))) return;
    for (int k = 0; k < LAYERS; ++k) imageStore(layers[k], at, uvec4(0u));
}
