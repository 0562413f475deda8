// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Whose pixel is this: a fragment's slot, or one number for everything that the pass draws.
layout(location = 0) out uint id;
#ifdef CONSTANT_ID
layout(location = 0) uniform uint constant_id;
void main() { id = constant_id; }
#else
flat in uint fragment_slot;
void main() { id = fragment_slot; }
#endif
