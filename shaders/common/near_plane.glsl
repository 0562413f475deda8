// SPDX-License-Identifier: Apache-2.0
// What the near plane leaves of a triangle: a polygon of 0, 3 or 4 corners.
int cutByNearPlane(vec4 clip[3], out vec4 corner[4]) {
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        vec4 a = clip[k], b = clip[(k + 1) % 3];
        float a_in = a.w - a.z, b_in = b.w - b.z;
        if (a_in >= 0.0) corner[count++] = a;
        if ((a_in >= 0.0) != (b_in >= 0.0)) corner[count++] = mix(a, b, a_in / (a_in - b_in));
    }
    return count;
}

bool isCut(vec4 clip[3]) { return clip[0].z > clip[0].w || clip[1].z > clip[1].w || clip[2].z > clip[2].w; }
