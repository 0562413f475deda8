// Which samples of a picture a triangle covers, found as a rasteriser finds them: corners are rounded to a grid, and a
// sample on an edge belongs to one of the two triangles there.
const int kGrid = 256;  // steps along a pixel

// A triangle on a picture.
struct Flat {
    ivec2 at[3];            // corners, grid steps
    vec3 depth;             // at the corners
    ivec2 low, high;        // px, pixels that may hold covered samples, cut to the picture; low > high: none
    dvec2 edge_01, edge_02; // from the first corner, grid steps
    double area;            // twice the area, grid steps squared; <= 0: faces away
};

const float kFarthest = 1048576.0;  // px; beyond it corners are moved, so that products stay exact

// `window`: corners in px; samples of a pixel lie between `least` and `most` grid steps from its corner.
Flat flatten(vec2 window[3], vec3 depth, ivec2 least, ivec2 most, ivec2 size) {
    Flat f;
    for (int k = 0; k < 3; ++k) f.at[k] = ivec2(floor(clamp(window[k], -kFarthest, kFarthest) * float(kGrid) + 0.5));
    f.depth = depth;
    ivec2 first = min(f.at[0], min(f.at[1], f.at[2])), last = max(f.at[0], max(f.at[1], f.at[2]));
    f.low = max((first - most + kGrid - 1) >> 8, ivec2(0));
    f.high = min((last - least) >> 8, size - 1);
    f.edge_01 = dvec2(f.at[1] - f.at[0]);
    f.edge_02 = dvec2(f.at[2] - f.at[0]);
    f.area = f.edge_01.x * f.edge_02.y - f.edge_01.y * f.edge_02.x;
    return f;
}

bool isEmpty(Flat f) { return any(greaterThan(f.low, f.high)) || f.area <= 0.0; }

ivec2 boxOf(Flat f) { return f.high - f.low + 1; }

// Change of depth a grid step along x and y.
vec2 depthSlope(Flat f) {
    float to_1 = f.depth[1] - f.depth[0], to_2 = f.depth[2] - f.depth[0];
    vec2 a = vec2(f.edge_01), b = vec2(f.edge_02);
    return vec2(to_1 * b.y - to_2 * a.y, to_2 * a.x - to_1 * b.x) / float(f.area);
}

float depthAt(Flat f, vec2 slope, ivec2 sample_at) {
    precise float depth = f.depth[0] + dot(slope, vec2(sample_at - f.at[0]));
    // The slope of a sliver is not known well.
    return clamp(depth, min(f.depth[0], min(f.depth[1], f.depth[2])), max(f.depth[0], max(f.depth[1], f.depth[2])));
}

// Edges of which a sample on them is inside: those to the left and the upper ones.
bool keepsItsEdge(ivec2 edge) { return edge.y < 0 || (edge.y == 0 && edge.x < 0); }

// Exact up to a box of 64 px.
bool coversNear(Flat f, ivec2 sample_at) {
    for (int k = 0; k < 3; ++k) {
        ivec2 edge = f.at[(k + 1) % 3] - f.at[k], to = sample_at - f.at[k];
        int side = edge.x * to.y - edge.y * to.x;
        if (side < (keepsItsEdge(edge) ? 0 : 1)) return false;
    }
    return true;
}

// Exact for any triangle.
bool covers(Flat f, ivec2 sample_at) {
    for (int k = 0; k < 3; ++k) {
        ivec2 edge = f.at[(k + 1) % 3] - f.at[k];
        dvec2 along = dvec2(edge), to = dvec2(sample_at - f.at[k]);
        double side = along.x * to.y - along.y * to.x;
        if (side < (keepsItsEdge(edge) ? 0.0 : 1.0)) return false;
    }
    return true;
}
