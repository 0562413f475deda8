// SPDX-License-Identifier: Apache-2.0
// Part of a triangle, shared by the lanes of a work group: what the triangle covers between pixels `low` and `high`.
void fillBox(Large t, ivec2 low, ivec2 high) {
    Flat f = t.flat_on_view;
    low = max(low, f.low);
    ivec2 box = min(high, f.high) - low + 1;
    if (any(lessThanEqual(box, ivec2(0)))) return;
    Edges e = edgesFrom(f, low);
    for (int k = int(gl_LocalInvocationIndex); k < box.x * box.y; k += int(gl_WorkGroupSize.x)) {
        ivec2 away = ivec2(k % box.x, k / box.x), pixel = low + away;
        if (t.view != kCamera) {
            ivec2 middle = ivec2(kGrid / 2);
            if (covers(e, kGrid * away + middle)) putShadow(pixel, t.view - 1, depthAt(f, kGrid * pixel + middle) + t.shift);
            continue;
        }
        uint covered = 0u;
        for (int i = 0; i < SAMPLES; ++i) {
            if (covers(e, kGrid * away + sample_at[i])) covered |= 1u << i;
        }
        if (covered != 0u) putCamera(f, pixel, covered, t.name);
    }
}
