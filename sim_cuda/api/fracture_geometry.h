// SPDX-License-Identifier: Apache-2.0
// Static draw data of one body, made once per model and size (geometry.md 6); fracture chooses what is shown.
#pragma once
#include <cstdint>
#include <vector>

#include "sim_cuda/api/vectors.h"

namespace demolish {

/// Vertex of everything that is drawn with a fragment's rigid motion; 24 bytes, laid out so in GLSL and CUDA.
struct SurfaceVertex {
    Float3 position;  ///< m, rest position in the body frame
    uint32_t normal;  ///< octahedral, 2 x snorm16, x in the low half
    uint32_t place;   ///< outside: triangle of the mesh that its looks are of; broken faces: depth from the
                      ///< outside 0..1 and bend -1 pit .. 1 ridge, 2 x float16, the depth in the low half
    uint32_t cell;    ///< particle id
};
static_assert(sizeof(SurfaceVertex) == 24);

/// One part of the face between two cells, tessellated. Triangles wind counter-clockwise seen from cell_b, so
/// that their normal points from cell_a to cell_b; side b draws them reversed.
struct InteriorFace {
    uint32_t cell_a, cell_b;              ///< cell_a < cell_b
    uint32_t first_vertex, vertex_count;  ///< into face_vertices
    uint32_t first_index, index_count;    ///< into face_indices; indices are local to the face's vertices
    uint32_t bond;  ///< index of the bond of (cell_a, cell_b), kNoBond for a sliver face
    uint32_t reserved = 0;
};
static_assert(sizeof(InteriorFace) == 32);
inline constexpr uint32_t kNoBond = 0xffffffffu;

/// Edge of the exterior surface that lies on the border of two cells: drawn as a hairline when their bond is
/// broken while both are in one fragment.
struct CrackEdge {
    uint32_t vertex_0, vertex_1;  ///< exterior vertices, on the side of cell_a
    uint32_t cell_a, cell_b;
    uint32_t bond;  ///< kNoBond: shown when cell_a and cell_b are in different fragments only
};

/// A triangle of the mesh. It is drawn in the parts of its cells where these are of several fragments; else
/// in one, or, beside triangles that are drawn in parts, in as few as go through the points where those end,
/// so that no gap opens.
struct ExteriorTriangle {
    uint32_t first_index, index_count;  ///< into exterior_indices: the parts of all its cells
    uint32_t first_cell, cell_count;    ///< into exterior_cells
    uint32_t first_rim, rim_count;      ///< into exterior_rim: from the first corner counter-clockwise round
                                        ///< it; rim_count 0: always drawn in parts
    uint32_t corner_1, corner_2;        ///< places of the other corners in the rim
    uint32_t neighbour[3];  ///< triangle beyond the side that begins at each corner, or kNoNeighbour
    uint32_t reserved = 0;
};
static_assert(sizeof(ExteriorTriangle) == 48);
inline constexpr uint32_t kNoNeighbour = 0xffffffffu;

/// What keeps a point of the outside from leaving the body's shape when it slides.
enum class SlideKind : uint32_t {
    kPlane,  ///< smooth round it: along the surface
    kEdge,   ///< on a sharp edge: along that
    kNone,   ///< a corner
};

/// A place on the outside, one for all exterior vertices and the pool vertex that stand on it.
struct OutsidePoint {
    Float3 position;    ///< m, at rest
    uint32_t triangle;  ///< of the mesh: one that it lies in
    Float3 normal;      ///< unit, outward: mean of the triangles round it
    float spacing;      ///< m, h of its body
    Float3 axis;        ///< unit: normal of the plane, or direction of the edge, along which it slides
    float reach;        ///< m, how far it may slide
    SlideKind kind;
    uint32_t cell;    ///< one whose outside it lies on
    uint32_t pool;    ///< pool vertex, or kNoPool
    float waves = 0;  ///< m, height of its body's (breakWaves); 0 until the body has a material
};
static_assert(sizeof(OutsidePoint) == 64);
inline constexpr uint32_t kNoPool = 0xffffffffu;

/// A triangle of the mesh with what its corners carry: what slides over it takes that up.
struct MeshTriangle {
    Float3 corner[3];       ///< m
    uint32_t normal[3];     ///< octahedral
    uint32_t chart[3];      ///< differs at a corner from that of a neighbour whose looks do not go on there
    uint32_t neighbour[3];  ///< triangle beyond the side from corner k to k + 1, or kNoNeighbour
};
static_assert(sizeof(MeshTriangle) == 72);

/// Looks of a triangle of the mesh.
struct TriangleLook {
    Float2 uv[3], second_uv[3];
    uint32_t colour[3];  ///< as CornerAttributes
    uint32_t material;
};
static_assert(sizeof(TriangleLook) == 64);

/// Where an exterior vertex belongs: its point, and the triangle of the mesh that its normal and UV are of.
struct ExteriorHome {
    uint32_t point, triangle;
};

/// A crack edge at one of its ends.
struct PointCrack {
    uint32_t edge, other;  ///< of crack_edges; the point at the far end
};

struct FractureGeometry {
    std::vector<SurfaceVertex> exterior;               ///< X: vertices grouped by cell
    std::vector<ExteriorTriangle> exterior_triangles;  ///< one per triangle of the mesh
    std::vector<uint32_t> exterior_cells;              ///< particle ids, ascending for each triangle
    std::vector<uint32_t> exterior_indices;            ///< three per triangle
    std::vector<uint32_t> exterior_rim;                ///< exterior vertices
    std::vector<Float3> pool;                          ///< P: unique interior rest positions
    std::vector<uint8_t> pool_on_surface;        ///< 1: on the outer surface, never moves (keys A, B, C)
    std::vector<InteriorFace> faces;             ///< F
    std::vector<uint32_t> face_vertices;         ///< pool ids, per face
    std::vector<uint16_t> face_indices;          ///< three per triangle, local to the face
    std::vector<uint32_t> pool_corner_start;     ///< CSR over pool vertices into pool_corners, size pool + 1
    std::vector<uint32_t> pool_corner_face;      ///< face of each triangle corner that uses the pool vertex
    std::vector<uint32_t> pool_corner_next;      ///< pool id of the next vertex round that triangle
    std::vector<uint32_t> pool_corner_previous;  ///< pool id of the previous vertex round that triangle
    std::vector<CrackEdge> crack_edges;          ///< K
    std::vector<OutsidePoint> points;            ///< of the outside
    std::vector<ExteriorHome> exterior_home;     ///< per exterior vertex
    std::vector<MeshTriangle> mesh_triangles;    ///< as exterior_triangles
    std::vector<TriangleLook> looks;             ///< likewise; empty where no triangle has a material
    std::vector<uint32_t> point_corner_start;    ///< CSR over points: corners of parts of the outside there
    std::vector<uint32_t> point_corner_next;     ///< point that follows round that part
    std::vector<uint32_t> point_corner_previous;
    std::vector<uint32_t> point_crack_start;  ///< CSR over points: crack edges that end there
    std::vector<PointCrack> point_cracks;
};

}  // namespace demolish
