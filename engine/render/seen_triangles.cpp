// SPDX-License-Identifier: Apache-2.0
// Stretches of triangles go to all cores. Corners that follow each other are often the same, so that each
// stretch remembers some.
#include "engine/render/seen_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "engine/render/mesh_motion.h"

namespace demolish::engine {
namespace {

constexpr uint32_t kStretch = 3 * 8192;  // indices
constexpr uint32_t kRemembered = 256, kNone = 0xffffffffu;
constexpr size_t kLeastBytes = 64;

/// A corner on every picture.
using Places = std::array<PicturePoint, SeenTriangles::kMostPictures>;

class Corners {
  public:
    Corners(const MeshMotion& motion, std::span<const MeshVertex> vertices,
            std::span<const SampleGrid> pictures)
        : motion_(motion), vertices_(vertices), pictures_(pictures) {
        index_.fill(kNone);
    }

    const Places& at(uint32_t index) {
        const uint32_t row = index % kRemembered;
        Places& places = places_[row];
        if (index_[row] == index) return places;
        index_[row] = index;
        const glm::vec3 world = motion_.placeOf(vertices_[index]);
        for (size_t k = 0; k < pictures_.size(); ++k) places[k] = pictures_[k].placeOf(world);
        return places;
    }

  private:
    const MeshMotion& motion_;
    std::span<const MeshVertex> vertices_;
    std::span<const SampleGrid> pictures_;
    std::array<uint32_t, kRemembered> index_;
    std::array<Places, kRemembered> places_;
};

/// One of a mesh's two lists of triangles.
struct Listed {
    std::span<const MeshVertex> vertices;
    std::span<const uint32_t> indices;
    bool both_sides;
};

void findIn(const Listed& listed, const MeshMotion& motion, std::span<const SampleGrid> pictures,
            size_t first, SeenTriangles::Found& found) {
    for (auto& list : found) list.clear();
    Corners corners(motion, listed.vertices, pictures);
    const size_t end = std::min(listed.indices.size(), first + kStretch);
    for (size_t i = first; i + 2 < end; i += 3) {
        const uint32_t a = listed.indices[i], b = listed.indices[i + 1], c = listed.indices[i + 2];
        const Places at_a = corners.at(a), at_b = corners.at(b), at_c = corners.at(c);
        for (size_t k = 0; k < pictures.size(); ++k)
            if (pictures[k].mayShow(at_a[k], at_b[k], at_c[k], listed.both_sides))
                found[k].insert(found[k].end(), {a, b, c});
    }
}

}  // namespace

void SeenTriangles::find(const FractureMesh& mesh, std::span<const SampleGrid> pictures, bool both_sides) {
    lists_.resize(pictures.size());
    const MeshMotion motion(mesh);
    const auto search = [&](const gl::Buffer& vertices, StreamId indices, uint32_t command, bool backs,
                            TriangleList SeenList::*side) {
        const gl::BufferReading corners(vertices), listed(mesh.stream(indices));
        const size_t count = std::min<size_t>(commandOf(mesh, command).count, listed.as<uint32_t>().size());
        const Listed all{corners.as<MeshVertex>(), listed.as<uint32_t>().first(count), backs};
        stretches_.resize((all.indices.size() + kStretch - 1) / kStretch);
        tbb::parallel_for(size_t{0}, stretches_.size(), [&](size_t k) {
            stretches_[k].resize(pictures.size());
            findIn(all, motion, pictures, k * kStretch, stretches_[k]);
        });
        collect(side);
    };
    search(mesh.exteriorVertices(), StreamId::kExteriorIndices, kExteriorCommand, both_sides,
           &SeenList::exterior);
    search(mesh.stream(StreamId::kInteriorVertices), StreamId::kInteriorIndices, kInteriorCommand, false,
           &SeenList::interior);
}

void SeenTriangles::collect(TriangleList SeenList::*side) {
    for (size_t k = 0; k < lists_.size(); ++k) {
        TriangleList& list = lists_[k].*side;
        size_t count = 0;
        for (const Found& found : stretches_) count += found[k].size();
        list.count = static_cast<uint32_t>(count);
        if (list.indices.size() == 0) list.indices = gl::Buffer::resizable(kLeastBytes, GL_STREAM_DRAW);
        list.indices.resize(std::max(kLeastBytes, count * sizeof(uint32_t)));
        size_t at = 0;
        for (const Found& found : stretches_) {
            const auto bytes = std::as_bytes(std::span(found[k]));
            list.indices.upload(bytes, at);
            at += bytes.size();
        }
    }
}

}  // namespace demolish::engine
