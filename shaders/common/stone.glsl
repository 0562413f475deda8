// SPDX-License-Identifier: Apache-2.0
// Stone that nobody has polished, of the floor's tiles and of colliders. `cloud`: noise, from -1 to 1.
float stoneRoughness(float cloud) {
    return clamp(0.82 + 0.1 * cloud, 0.05, 1.0);
}
