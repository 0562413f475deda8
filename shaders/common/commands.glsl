// SPDX-License-Identifier: Apache-2.0
// The body's draw commands, which say how much there is to draw.
struct DrawCommand { uint count, instance_count, first_index, base_vertex, base_instance; };
layout(std430, binding = 6) readonly buffer Commands { DrawCommand commands[]; };
const uint kInteriorCommand = 0u, kCrackCommand = 1u, kExteriorCommand = 2u;
