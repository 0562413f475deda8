// SPDX-License-Identifier: Apache-2.0
// The same opening, width on the picture and slope as in shaders/common/crack.glsl.
#include "engine/render/seen_cracks.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/gtc/packing.hpp>

#include "engine/render/mesh_motion.h"

namespace demolish::engine {
namespace {

// A little more, or less, than the shader's.
constexpr float kGoneAt = 3.01f;        // opening, in widths
constexpr float kFacing = 0.018f;       // cosine, at which lines are gone
constexpr float kLeastPixels = 0.001f;  // thinner lines hide less than a step of a picture's colours
constexpr size_t kStretch = 4096;       // lines
constexpr uint32_t kLeastLines = 64;

/// As FractureMeshData::crack_edges.
struct Edge {
    uint32_t vertex_0, vertex_1, cell_a, cell_b, bond;
};
static_assert(sizeof(Edge) == 20);

class Lines {
  public:
    Lines(const MeshMotion& motion, std::span<const MeshVertex> vertices, float width,
          const FrameUniforms* frame)
        : motion_(motion), vertices_(vertices), width_(width), frame_(frame) {}

    /// `widths`: m at both ends, two halves.
    bool mayShow(const Edge& edge, uint32_t widths) const {
        const MeshTransform& of_a = motion_.transformOf(motion_.fragmentOf(edge.cell_a));
        const MeshTransform& of_b = motion_.transformOf(motion_.fragmentOf(edge.cell_b));
        const glm::vec2 wide = glm::unpackHalf2x16(widths);
        return mayShow(vertices_[edge.vertex_0], wide.x, of_a, of_b) ||
               mayShow(vertices_[edge.vertex_1], wide.y, of_a, of_b);
    }

  private:
    bool mayShow(const MeshVertex& end, float wide, const MeshTransform& of_a,
                 const MeshTransform& of_b) const {
        const glm::vec3 place = MeshMotion::moved(of_a, end.position);
        if (&of_a != &of_b && glm::distance(place, MeshMotion::moved(of_b, end.position)) > kGoneAt * width_)
            return false;
        if (frame_ == nullptr) return true;
        const glm::vec3 to_eye = glm::vec3(frame_->eye) - place;
        const float distance = glm::length(to_eye);
        const float facing = glm::dot(rotated(of_a.rotation, normalOf(end.normal)), to_eye);
        if (facing < kFacing * distance) return false;
        const glm::mat4& to_clip = frame_->view_projection;
        const float w =
            to_clip[0].w * place.x + to_clip[1].w * place.y + to_clip[2].w * place.z + to_clip[3].w;
        const float pixels =
            wide * frame_->viewport.y / (2 * frame_->depth_range.z * std::max(w, frame_->depth_range.x));
        return pixels > kLeastPixels;
    }

    const MeshMotion& motion_;
    std::span<const MeshVertex> vertices_;
    float width_;
    const FrameUniforms* frame_;
};

}  // namespace

void SeenCracks::find(const FractureMesh& mesh, float width, const FrameUniforms* frame) {
    const MeshMotion motion(mesh);
    const gl::BufferReading edge_bytes(mesh.crackEdges()), vertex_bytes(mesh.exteriorVertices()),
        line_bytes(mesh.stream(StreamId::kCrackEdges));
    const auto edges = edge_bytes.as<Edge>();
    const auto vertices = vertex_bytes.as<MeshVertex>();
    const auto all = line_bytes.as<Line>();
    const auto lines = all.first(std::min<size_t>(commandOf(mesh, kCrackCommand).instances, all.size()));
    const Lines all_lines(motion, vertices, width, frame);
    std::vector<uint8_t> shows(lines.size());
    tbb::parallel_for(size_t{0}, (lines.size() + kStretch - 1) / kStretch, [&](size_t stretch) {
        const size_t end = std::min(lines.size(), (stretch + 1) * kStretch);
        for (size_t i = stretch * kStretch; i < end; ++i) {
            const auto [edge, widths] = lines[i];
            shows[i] = widths != 0 && all_lines.mayShow(edges[edge], widths) ? 1 : 0;
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
