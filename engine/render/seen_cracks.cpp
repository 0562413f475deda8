// SPDX-License-Identifier: Apache-2.0
// The same opening as in shaders/common/crack.glsl.
#include "engine/render/seen_cracks.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/render/mesh_motion.h"

namespace demolish::engine {
namespace {

constexpr float kGoneAt = 3.01f;   // opening, in widths; a little more than the shader's
constexpr size_t kStretch = 4096;  // lines
constexpr uint32_t kLeastLines = 64;

/// As FractureMeshData::crack_edges.
struct Edge {
    uint32_t vertex_0, vertex_1, cell_a, cell_b, bond;
};
static_assert(sizeof(Edge) == 20);

bool mayShow(const Edge& edge, std::span<const MeshVertex> vertices, const MeshMotion& motion,
             float gone_at) {
    const uint32_t a = motion.fragmentOf(edge.cell_a), b = motion.fragmentOf(edge.cell_b);
    if (a == b) return true;
    const MeshTransform &of_a = motion.transformOf(a), &of_b = motion.transformOf(b);
    for (const uint32_t vertex : {edge.vertex_0, edge.vertex_1}) {
        const glm::vec3& p = vertices[vertex].position;
        if (!(glm::distance(MeshMotion::moved(of_a, p), MeshMotion::moved(of_b, p)) > gone_at)) return true;
    }
    return false;
}

}  // namespace

void SeenCracks::find(const FractureMesh& mesh, float width) {
    const MeshMotion motion(mesh);
    const gl::BufferReading edge_bytes(mesh.crackEdges()), vertex_bytes(mesh.exteriorVertices()),
        line_bytes(mesh.stream(StreamId::kCrackEdges));
    const auto edges = edge_bytes.as<Edge>();
    const auto vertices = vertex_bytes.as<MeshVertex>();
    const auto all = line_bytes.as<Line>();
    const auto lines = all.first(std::min<size_t>(commandOf(mesh, kCrackCommand).instances, all.size()));
    std::vector<uint8_t> shows(lines.size());
    tbb::parallel_for(size_t{0}, (lines.size() + kStretch - 1) / kStretch, [&](size_t stretch) {
        const size_t end = std::min(lines.size(), (stretch + 1) * kStretch);
        for (size_t i = stretch * kStretch; i < end; ++i) {
            const bool open = lines[i].widths != 0;
            shows[i] = open && mayShow(edges[lines[i].edge], vertices, motion, kGoneAt * width) ? 1 : 0;
        }
    });
    found_.clear();
    for (size_t i = 0; i < lines.size(); ++i)
        if (shows[i] != 0) found_.push_back(lines[i]);
    upload();
}

void SeenCracks::upload() {
    const auto lines = std::max(kLeastLines, static_cast<uint32_t>(found_.size()));
    if (!lines_) lines_ = gl::Buffer::resizable(sizeof(Line), GL_STREAM_DRAW);
    lines_.resize(lines * sizeof(Line));
    lines_.upload(std::as_bytes(std::span(found_)));
    if (indexed_ >= lines) return;
    indexed_ = 2 * lines;
    std::vector<uint32_t> corners;
    corners.reserve(size_t{6} * indexed_);
    for (uint32_t line = 0; line < indexed_; ++line)
        for (const uint32_t corner : {0u, 1u, 2u, 2u, 1u, 3u}) corners.push_back(4 * line + corner);
    indices_ = gl::Buffer::immutable(corners.size() * sizeof(uint32_t), corners.data());
}

}  // namespace demolish::engine
