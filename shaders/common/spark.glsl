// SPDX-License-Identifier: Apache-2.0
// How a spark glows and bursts.
struct Spark {
    vec4 streak;  // px: its way, its radius, its way had it been there all the time, reach of its burst
    vec2 taper;   // at its tail and its head: shares of the time for which the film is open that have passed
    vec3 light;   // of its disc, over a white surface in the sun
    uint seed;
};

const float kLeastSparkRadius = 0.8;  // px; a smaller one is drawn that large, and fainter
const float kHottest = 60.0;          // light of a disc that has just been struck: it is spread over all its way
const float kBurstSize = 26.0;        // radii
const float kBurstHeat = 0.08;        // heat that it loses while it bursts

// White-yellow as it is struck, then orange, at last dark red.
vec3 sparkLight(float heat) {
    float hot = heat * heat;
    vec3 colour = mix(vec3(1.0, 0.06, 0.0), vec3(1.0, 0.24, 0.015), smoothstep(0.0, 0.45, hot));
    colour = mix(colour, vec3(1.0, 0.52, 0.13), smoothstep(0.35, 1.0, hot));
    return kHottest * hot * heat * colour;
}

// How far it has burst, 0: not, or no longer.
float sparkBurst(uint seed, float heat) {
    if (grainDraw(seed + 29u) > 0.2) return 0.0;
    float begun = (mix(0.5, 0.95, grainDraw(seed + 37u)) - heat) / kBurstHeat;
    return begun > 0.0 && begun < 1.0 ? sqrt(begun) : 0.0;
}
