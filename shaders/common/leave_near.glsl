// SPDX-License-Identifier: Apache-2.0
// Broken faces that near faces replace are put outside the picture.
#include "common/near_faces.glsl"
layout(location = 29) uniform uint leaves_near;  // 1: they are

vec4 unlessReplaced(vec4 position, uint cell) {
    return leaves_near != 0u && isReplaced(cell) ? vec4(2.0, 2.0, 2.0, 1.0) : position;
}
