// SPDX-License-Identifier: Apache-2.0
// A small triangle by one lane: into the camera's picture, and into a region of the shadow map (common/raster.glsl).

// One loop and not two, or a group of lanes would take as long as the tallest box times the widest.
bool fillCamera(Flat f, uint name) {
    NearEdges e = nearEdges(f);
    ivec3 row = e.at_low, here = row, right = kGrid * e.along_x, up = kGrid * e.along_y;
    ivec2 pixel = f.low, box = boxOf(f);
    bool shows = false;
    for (int left = box.x * box.y; left > 0; --left) {
        uint covered = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            if (isInside(here + sample_at[i].x * e.along_x + sample_at[i].y * e.along_y)) covered |= 1u << i;
        }
        if (covered != 0u) shows = putCamera(f, pixel, covered, name) || shows;
        ++pixel.x;
        here += right;
        if (pixel.x > f.high.x) {
            pixel = ivec2(f.low.x, pixel.y + 1);
            row += up;
            here = row;
        }
    }
    return shows;
}

void fillShadow(Flat f, int region) {
    NearEdges e = nearEdges(f);
    ivec3 row = e.at_low + kGrid / 2 * (e.along_x + e.along_y), here = row, right = kGrid * e.along_x, up = kGrid * e.along_y;
    ivec2 texel = f.low, box = boxOf(f);
    float shift = shadowShift(f);
    for (int left = box.x * box.y; left > 0; --left) {
        if (isInside(here)) putShadow(texel, region, depthAt(f, kGrid * texel + kGrid / 2) + shift);
        ++texel.x;
        here += right;
        if (texel.x > f.high.x) {
            texel = ivec2(f.low.x, texel.y + 1);
            row += up;
            here = row;
        }
    }
}
