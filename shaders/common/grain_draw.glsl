// SPDX-License-Identifier: Apache-2.0
// Numbers that hang on a seed alone.
uint grainHash(uint h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}
float grainDraw(uint h) { return float(grainHash(h) >> 8) / 16777216.0; }
