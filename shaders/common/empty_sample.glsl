// SPDX-License-Identifier: Apache-2.0
// Samples that show nothing but floor and sky: what follows is never asked.
const bool kShowsBodies = false;
float depthAt(ivec2 pixel, int i) { return 0.0; }
uvec3 valueAt(ivec2 pixel, int i) { return uvec3(0u); }
Surface surfaceAt(ivec2 pixel, int i, vec3 position) { return floorSurface(position, vec3(0.0, -1.0, 0.0)); }
