// SPDX-License-Identifier: Apache-2.0
#version 450 core
// Broken faces near the camera, cut finer and moved by the relief. Their order is that of the mesh, so that a frame is the same
// every time.
layout(local_size_x = 128) in;
#include "common/gbuffer.glsl"
#include "common/near_triangle.glsl"
layout(std430, binding = 8) readonly buffer GroupSums { Sums sums[]; };
layout(std430, binding = 17) buffer NearIndices {
    uint near_command[5];
    uint near_groups[3];
    uint near_indices[];
};
layout(std430, binding = 18) writeonly buffer NearVertices { uvec2 near_words[]; };
layout(location = 34) uniform uvec2 room;  // triangles, vertices

shared Sums before, total;
shared uvec2 ends[gl_WorkGroupSize.x];  // of a round: triangles and vertices up to and with a lane's
shared uvec3 steps_of[gl_WorkGroupSize.x];

// Of the groups `from`, `from` + work group's size, ...: x, y of all, z, w of those before this one.
uvec4 sumsFrom(uint from, int k) {
    uvec4 sum = uvec4(0u);
    for (uint group = from; group < group_count; group += gl_WorkGroupSize.x) {
        uvec2 here = uvec2(sums[group].triangles[k], sums[group].vertices[k]);
        sum += uvec4(here, group < gl_WorkGroupID.x ? here : uvec2(0u));
    }
    return sum;
}

void addSums(uint from) {
    for (int k = 0; k < 4; ++k) {
        uvec4 sum = sumsFrom(from, k);
        atomicAdd(total.triangles[k], sum.x);
        atomicAdd(total.vertices[k], sum.y);
        atomicAdd(before.triangles[k], sum.z);
        atomicAdd(before.vertices[k], sum.w);
    }
}

// Of kMostSteps; 4: there is no room at all.
int chooseSteps() {
    for (int k = 0; k < 4; ++k) {
        if (total.triangles[k] <= room.x && total.vertices[k] <= room.y) return k;
    }
    return 4;
}

// Sum over the lanes before, and over all: x triangles, y vertices.
uvec2 sumBefore(uvec2 own, out uvec2 sum) {
    uint lane = gl_LocalInvocationIndex;
    ends[lane] = own;
    barrier();
    for (uint reach = 1u; reach < gl_WorkGroupSize.x; reach *= 2u) {
        uvec2 left = lane >= reach ? ends[lane - reach] : uvec2(0u);
        barrier();
        ends[lane] += left;
        barrier();
    }
    sum = ends[gl_WorkGroupSize.x - 1u];
    uvec2 result = ends[lane] - own;
    barrier();
    return result;
}

bool isLess(vec3 a, vec3 b) { return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z; }

// The same bits wherever it is asked for.
Corner mean(Corner c[3], vec3 w) {
    precise vec3 rest = w.x * c[0].rest + w.y * c[1].rest + w.z * c[2].rest;
    precise vec2 place = w.x * c[0].place + w.y * c[1].place + w.z * c[2].place;
    return Corner(rest, w.x * c[0].normal + w.y * c[1].normal + w.z * c[2].normal, place);
}

void sort(inout Corner a, inout Corner b, inout vec2 weights) {
    if (!isLess(b.rest, a.rest)) return;
    Corner first = a;
    a = b;
    b = first;
    weights = weights.yx;
}

// Whatever the order of the corners: a weight of 0 takes none of one.
Corner weighted(Corner a, Corner b, Corner c, vec3 w) {
    vec2 front = w.xy;
    sort(a, b, front);
    vec2 rear = vec2(front.y, w.z);
    sort(b, c, rear);
    front.y = rear.x;
    sort(a, b, front);
    return mean(Corner[](a, b, c), vec3(front, rear.y));
}

// On an edge of `steps` steps, at step `k` of `of` from `a`; the third corner is any.
Corner onEdge(Corner a, Corner b, uint k, uint of, uint steps) {
    uint at = k * steps / of;
    return at == 0u ? a : weighted(a, b, b, vec3(float(steps - at), float(at), 0.0) / float(steps));
}

// `i` steps of `of` towards the second corner, `j` towards the third.
Corner placeIn(NearTriangle near, uint i, uint j, uint of, uint most) {
    uvec3 steps = min(near.steps, uvec3(most));
    if (i == 0u && j == 0u) return near.corner[0];
    if (i == of) return near.corner[1];
    if (j == of) return near.corner[2];
    if (j == 0u) return onEdge(near.corner[0], near.corner[1], i, of, steps.x);
    if (i + j == of) return onEdge(near.corner[1], near.corner[2], j, of, steps.y);
    if (i == 0u) return onEdge(near.corner[2], near.corner[0], of - j, of, steps.z);
    return weighted(near.corner[0], near.corner[1], near.corner[2], vec3(of - i - j, i, j) / float(of));
}

void writeVertex(NearTriangle near, Corner c, uint vertex) {
    float per_metre = 1.0 / near.relief.y, height = near.relief.x * reliefShare(moved(near.motion, c.rest), c.place.x, near.relief);
    float wide = 0.06 * near.relief.y;  // over which its slope is taken
    vec3 normal = normalize(c.normal), here = reliefShape(c.rest, per_metre);
    vec3 first = normalize(cross(normal, abs(normal.y) < 0.7 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0))), second = cross(normal, first);
    vec3 along = wide * first + height * (reliefShape(c.rest + wide * first, per_metre) - here);
    vec3 across = wide * second + height * (reliefShape(c.rest + wide * second, per_metre) - here);
    vec3 rest = c.rest + height * here, bent = normalize(cross(along, across));
    near_words[3u * vertex] = floatBitsToUint(rest.xy);
    near_words[3u * vertex + 1u] = uvec2(floatBitsToUint(rest.z), packSnorm2x16(encodeOctahedral(bent)));
    near_words[3u * vertex + 2u] = uvec2(packHalf2x16(c.place), near.cell);
}

void writeIndices(uint place, uvec3 corners) {
    for (int k = 0; k < 3; ++k) near_indices[3u * place + uint(k)] = corners[k];
}

// Whose vertex `vertex` of a round is, and which of its own: x lane, y number.
uvec2 ownerOf(uint vertex) {
    uint low = 0u, high = gl_WorkGroupSize.x - 1u;
    while (low < high) {
        uint middle = (low + high) / 2u;
        if (vertex < ends[middle].y) high = middle;
        else low = middle + 1u;
    }
    return uvec2(low, vertex - (low > 0u ? ends[low - 1u].y : 0u));
}

// Vertex number 0, 1, ... in rows of equal `i`: (i, j).
uvec2 inRow(uint number, uint steps) {
    uint i = 0u;
    for (uint row = steps + 1u; number >= row; --row, ++i) number -= row;
    return uvec2(i, number);
}

// The vertices of a round are shared by its lanes, or few near triangles would keep all others waiting.
void writeVertices(uint first, uint count, uint most, uint vertex) {
    for (uint v = gl_LocalInvocationIndex; v < count; v += gl_WorkGroupSize.x) {
        uvec2 owner = ownerOf(v);
        NearTriangle near;
        nearTriangle(first + owner.x, near);
        near.steps = steps_of[owner.x];
        uint steps = stepsAcross(near.steps, most);
        uvec2 at = inRow(owner.y, steps);
        writeVertex(near, placeIn(near, at.x, at.y, steps, most), vertex + v);
    }
}

void writeTriangles(uint steps, uint triangle, uint vertex) {
    for (uint i = 0u; i < steps; ++i) {
        uint row = steps + 1u - i;  // vertices from here to where `i` is one more
        for (uint j = 0u; i + j < steps; ++j, ++vertex) {
            writeIndices(triangle++, uvec3(vertex, vertex + row, vertex + 1u));
            if (i + j + 1u < steps) writeIndices(triangle++, uvec3(vertex + row, vertex + row + 1u, vertex + 1u));
        }
        ++vertex;
    }
}

void main() {
    uint lane = gl_LocalInvocationIndex;
    if (lane < 4u) {
        before.triangles[lane] = before.vertices[lane] = 0u;
        total.triangles[lane] = total.vertices[lane] = 0u;
    }
    barrier();
    addSums(lane);
    barrier();
    int fits = chooseSteps(), chosen = min(fits, 3);
    uint most = kMostSteps[chosen];
    uvec2 share = fits == chosen ? shareOf(gl_WorkGroupID.x) : uvec2(0u);
    uvec2 place = uvec2(before.triangles[chosen], before.vertices[chosen]);
    if (gl_GlobalInvocationID.x == 0u) {
        near_groups[0] = 0u;  // for the next frame; this one's have begun
        if (fits == chosen) near_command[0] = 3u * total.triangles[chosen];
    }
    for (uint first = share.x; first < share.y; first += gl_WorkGroupSize.x) {
        NearTriangle near;
        bool is_near = first + lane < share.y && nearTriangle(first + lane, near);
        uint steps = is_near ? stepsAcross(near.steps, most) : 0u;
        steps_of[lane] = near.steps;
        uvec2 sum, own = sumBefore(is_near ? uvec2(trianglesIn(steps), verticesIn(steps)) : uvec2(0u), sum);
        if (is_near) writeTriangles(steps, place.x + own.x, place.y + own.y);
        writeVertices(first, sum.y, most, place.y);
        place += sum;
        barrier();  // until here the sums of this round are read; without it an H100 left triangles out
    }
}
