// SPDX-License-Identifier: Apache-2.0
const vec3 kCrackColour = vec3(0.09, 0.085, 0.08);  // of the dark inside of a crack, square root of the albedo
