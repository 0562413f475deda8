// SPDX-License-Identifier: Apache-2.0
// Is a triangle's cell of a look that is wanted? Near faces are never those of a transparent one.
#define CELL_LOOKS 10
#include "common/cell_look.glsl"

bool isShown(uint name) {
    if (hidden_looks == 0u) return true;
    BodyVertex v[3];
    fetchTriangle(name, v);
    return !isHidden(v[0].cell);
}
