// SPDX-License-Identifier: Apache-2.0
// A puff as a picture of its size sees it: all that is the same over its disc.
struct SeenPuff {
    vec4 position_radius;        // m; radius 0: it is not seen
    vec4 depth_age_heat_sunlit;  // as Puff; w: share of the sun that it sees
    vec4 air;                    // rgb: what the air before it adds to light; a: what it leaves of it
    vec4 place;                  // xy: its middle, px; z: radii per px; w: how much longer it is than a ball
    vec4 along;                  // xy: unit, the way it is drawn out, along right and up of the picture
};
