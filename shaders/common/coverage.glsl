// SPDX-License-Identifier: Apache-2.0
// Which samples of a picture a triangle covers, found as a rasteriser finds them: corners are rounded to a grid, and a
// sample on an edge belongs to one of the two triangles there.
const int kGrid = 256;  // steps along a pixel

// A triangle on a picture.
struct Flat {
    ivec2 at_0, at_1, at_2;      // corners, grid steps
    ivec2 low, high;             // px, pixels that may hold covered samples, cut to the picture
    float depth, least, most;    // at the first corner; within these of all corners
    vec2 slope;                  // of depth, along a grid step
    bool shows;                  // faces the viewer or is wanted from both sides, and the box is not empty
};

const float kFarthest = 1048576.0;  // px; beyond it corners are moved, so that products stay exact

ivec2 onGrid(vec2 window) { return ivec2(floor(clamp(window, -kFarthest, kFarthest) * float(kGrid) + 0.5)); }

// `w_`: corners in px; `z`: their depths; samples of a pixel lie between `least_at` and `most_at` grid steps from its corner.
Flat flatten(vec2 w_0, vec2 w_1, vec2 w_2, vec3 z, ivec2 least_at, ivec2 most_at, ivec2 size) {
    Flat f;
    f.at_0 = onGrid(w_0);
    f.at_1 = onGrid(w_1);
    f.at_2 = onGrid(w_2);
    f.low = max((min(f.at_0, min(f.at_1, f.at_2)) - most_at + kGrid - 1) >> 8, ivec2(0));
    f.high = min((max(f.at_0, max(f.at_1, f.at_2)) - least_at) >> 8, size - 1);
    dvec2 a = dvec2(f.at_1 - f.at_0), b = dvec2(f.at_2 - f.at_0);
    float area = float(a.x * b.y - a.y * b.x);
#ifdef FACES
    if (area < 0.0) {  // from behind: the other way round
        area = -area;
        z.yz = z.zy;
        dvec2 first = a;
        a = b;
        b = first;
        ivec2 at_1 = f.at_1;
        f.at_1 = f.at_2;
        f.at_2 = at_1;
    }
#endif
    f.shows = all(lessThanEqual(f.low, f.high)) && area > 0.0;
    vec2 to_1 = vec2(a), to_2 = vec2(b);
    float rise_1 = z.y - z.x, rise_2 = z.z - z.x;
    f.slope = vec2(rise_1 * to_2.y - rise_2 * to_1.y, rise_2 * to_1.x - rise_1 * to_2.x) / max(area, 1.0);
    f.depth = z.x;
    f.least = min(z.x, min(z.y, z.z));
    f.most = max(z.x, max(z.y, z.z));
    return f;
}

ivec2 boxOf(Flat f) { return f.high - f.low + 1; }

// The slope of a sliver is not known well.
float depthAt(Flat f, ivec2 sample_at) {
    precise float depth = f.depth + dot(f.slope, vec2(sample_at - f.at_0));
    return clamp(depth, f.least, f.most);
}

// Edges of which a sample on them is inside: those to the left and the upper ones. 0, otherwise 1.
int edgeIsOut(ivec2 edge) { return edge.y < 0 || (edge.y == 0 && edge.x < 0) ? 0 : 1; }

// On which side of its edges a point is: >= 0 inside. Exact up to a box of 64 px.
struct NearEdges {
    ivec3 along_x, along_y;  // change along a grid step
    ivec3 at_low;            // at the lower left corner of pixel `low`
};

int sideOf(ivec2 from, ivec2 to, ivec2 point) {
    ivec2 edge = to - from, away = point - from;
    return edge.x * away.y - edge.y * away.x - edgeIsOut(edge);
}

bool isNear(Flat f) {
    ivec2 a = abs(f.at_1 - f.at_0), b = abs(f.at_2 - f.at_0);
    return max(max(a.x, a.y), max(b.x, b.y)) <= 64 * kGrid;
}

NearEdges nearEdges(Flat f) {
    ivec2 corner = kGrid * f.low;
    NearEdges e;
    e.along_x = ivec3(f.at_0.y - f.at_1.y, f.at_1.y - f.at_2.y, f.at_2.y - f.at_0.y);
    e.along_y = ivec3(f.at_1.x - f.at_0.x, f.at_2.x - f.at_1.x, f.at_0.x - f.at_2.x);
    e.at_low = ivec3(sideOf(f.at_0, f.at_1, corner), sideOf(f.at_1, f.at_2, corner), sideOf(f.at_2, f.at_0, corner));
    return e;
}

bool isInside(ivec3 sides) { return (sides.x | sides.y | sides.z) >= 0; }

// The same, exact for any triangle.
struct Edges {
    dvec3 along_x, along_y, at_corner;
};

double farSideOf(ivec2 from, ivec2 to, ivec2 point) {
    dvec2 edge = dvec2(to - from), away = dvec2(point - from);
    return edge.x * away.y - edge.y * away.x - double(edgeIsOut(to - from));
}

// `corner`: lower left of a pixel, px.
Edges edgesFrom(Flat f, ivec2 corner) {
    ivec2 at = kGrid * corner;
    Edges e;
    e.along_x = dvec3(f.at_0.y - f.at_1.y, f.at_1.y - f.at_2.y, f.at_2.y - f.at_0.y);
    e.along_y = dvec3(f.at_1.x - f.at_0.x, f.at_2.x - f.at_1.x, f.at_0.x - f.at_2.x);
    e.at_corner = dvec3(farSideOf(f.at_0, f.at_1, at), farSideOf(f.at_1, f.at_2, at), farSideOf(f.at_2, f.at_0, at));
    return e;
}

// `away`: from the corner, grid steps.
bool covers(Edges e, ivec2 away) {
    dvec3 sides = e.at_corner + double(away.x) * e.along_x + double(away.y) * e.along_y;
    return min(sides.x, min(sides.y, sides.z)) >= 0.0;
}
