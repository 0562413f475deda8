// SPDX-License-Identifier: Apache-2.0
// Values of FLOOR and TONE: engine::FloorMaterial and engine::ToneCurve.
#define FLOOR_CHECKER 0
#define FLOOR_CONCRETE 1
#define FLOOR_PLANKS 2
#define FLOOR_GRID 3
#define FLOOR_SWEEP 4
#define FLOOR_SHADOW 5
#define TONE_FILM 0
#define TONE_AGX 1
#define TONE_NEUTRAL 2
