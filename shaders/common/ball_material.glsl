// SPDX-License-Identifier: Apache-2.0
// Iron of the projectiles.
const vec3 kBallAlbedo = vec3(0.23, 0.215, 0.205);
const float kBallRoughness = 0.36;
