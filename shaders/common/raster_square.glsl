// A square of kTaskEdge px of one triangle, shared by so many lanes.
#include "common/raster.glsl"

void fillBox(Flat f, int view, uint name, ivec2 corner, int lane, int lanes) {
    if (isEmpty(f)) return;
    ivec2 low = max(f.low, corner), high = min(f.high, corner + kTaskEdge - 1);
    if (any(greaterThan(low, high))) return;
    vec2 slope = depthSlope(f);
    float shift = view == kCamera ? 0.0 : shadowShift(f, slope);
    ivec2 box = high - low + 1;
    for (int k = lane; k < box.x * box.y; k += lanes) {
        ivec2 pixel = low + ivec2(k % box.x, k / box.x);
        for (int i = 0; i < (view == kCamera ? sample_count : 1); ++i) {
            ivec2 at = kGrid * pixel + (view == kCamera ? sample_at[i] : ivec2(kGrid / 2));
            if (!covers(f, at)) continue;
            float depth = depthAt(f, slope, at);
            if (view == kCamera) putCamera(pixel, i, depth, name);
            else putShadow(pixel, view - 1, depth + shift);
        }
    }
}

// What the near plane leaves of a triangle: a polygon of 0, 3 or 4 corners.
int cutByNearPlane(vec4 clip[3], out vec4 corner[4]) {
    int count = 0;
    for (int k = 0; k < 3; ++k) {
        vec4 a = clip[k], b = clip[(k + 1) % 3];
        float a_in = a.w - a.z, b_in = b.w - b.z;
        if (a_in >= 0.0) corner[count++] = a;
        if ((a_in >= 0.0) != (b_in >= 0.0)) corner[count++] = mix(a, b, a_in / (a_in - b_in));
    }
    return count;
}

void fillSquare(uint name, int view, ivec2 square, int lane, int lanes) {
    vec3 p[3];
    cornersOf(name, p);
    ivec2 corner = kTaskEdge * square;
    if (view != kCamera) {
        fillBox(shadowFlat(p, view - 1), view, name, corner, lane, lanes);
        return;
    }
    vec4 clip[3], left[4];
    for (int k = 0; k < 3; ++k) clip[k] = frame.view_projection * vec4(p[k], 1.0);
    int count = cutByNearPlane(clip, left);
    for (int k = 2; k < count; ++k) {
        clip = vec4[](left[0], left[k - 1], left[k]);
        fillBox(cameraFlat(clip), view, name, corner, lane, lanes);
    }
}
