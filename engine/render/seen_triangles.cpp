// SPDX-License-Identifier: Apache-2.0
// Stretches of triangles go to all cores. Corners that follow each other are often the same, so that each
// stretch remembers some. What hides others is known once all have been looked at: a second round leaves out
// what is hidden.
#include "engine/render/seen_triangles.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace demolish::engine {
namespace {

constexpr uint32_t kStretch = 3 * 8192;  // indices
constexpr uint32_t kRemembered = 256, kNone = 0xffffffffu;

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
        const MeshVertex& vertex = vertices_[index];
        follow(motion_.fragmentOf(vertex.cell));
        for (size_t k = 0; k < pictures_.size(); ++k) places[k] = projections_[k].placeOf(vertex.position);
        return places;
    }

  private:
    /// Corners that follow each other are mostly of one fragment.
    void follow(uint32_t fragment) {
        if (fragment == fragment_) return;
        fragment_ = fragment;
        const glm::mat4 motion = MeshMotion::matrixOf(motion_.transformOf(fragment));
        for (size_t k = 0; k < pictures_.size(); ++k) projections_[k] = pictures_[k].projectionOf(motion);
    }

    const MeshMotion& motion_;
    std::span<const MeshVertex> vertices_;
    std::span<const SampleGrid> pictures_;
    std::array<uint32_t, kRemembered> index_;
    std::array<Places, kRemembered> places_;
    uint32_t fragment_ = kNone;
    std::array<Projection, SeenTriangles::kMostPictures> projections_;
};

}  // namespace

/// One of a mesh's lists of triangles.
struct SeenTriangles::Listed {
    std::span<const MeshVertex> vertices;
    std::span<const uint32_t> indices;
    bool both_sides;
    std::span<const uint32_t> replaced;  ///< of each cell: 1 where others are shown; or empty
    bool isReplaced(uint32_t corner) const {
        return !replaced.empty() && replaced[vertices[corner].cell] != 0;
    }
};

struct SeenTriangles::Search {
    const MeshMotion& motion;
    std::span<const SampleGrid> pictures;
    bool hidden;  ///< is asked for
};

void SeenTriangles::findIn(const Search& search, const Listed& listed, size_t first, Found& found) {
    const std::span<const SampleGrid> pictures = search.pictures;
    found.candidates.clear();
    found.indices.resize(pictures.size());
    for (auto& list : found.indices) list.clear();
    Corners corners(search.motion, listed.vertices, pictures);
    const size_t end = std::min(listed.indices.size(), first + kStretch);
    Cover cover;
    for (size_t i = first; i + 2 < end; i += 3) {
        const uint32_t abc[3] = {listed.indices[i], listed.indices[i + 1], listed.indices[i + 2]};
        if (listed.isReplaced(abc[0])) continue;
        const Places a = corners.at(abc[0]), b = corners.at(abc[1]), c = corners.at(abc[2]);
        for (size_t k = 0; k < pictures.size(); ++k) {
            const Cover::Kind kind = pictures[k].findCover(a[k], b[k], c[k], listed.both_sides, cover);
            if (kind == Cover::Kind::kNothing) continue;
            if (k > 0 || search.hidden)
                found.indices[k].insert(found.indices[k].end(), abc, abc + 3);
            else if (kind == Cover::Kind::kAnything || cover.is_sliver)
                found.candidates.addShown(abc);
            else
                found.candidates.add(abc, {a[0], b[0], c[0]}, cover, pictures[0], nearest_);
        }
    }
}

void SeenTriangles::find(const FractureMesh& mesh, const NearFaces* near,
                         std::span<const SampleGrid> pictures, const Wanted& wanted) {
    lists_.resize(pictures.size());
    nearest_.clear(wanted.hidden ? 0 : pictures[0].sampleCount());
    const MeshMotion motion(mesh);
    const Search search{motion, pictures, wanted.hidden};
    const auto searchIn = [&](const Listed& all, std::vector<Found>& stretches) {
        stretches.resize((all.indices.size() + kStretch - 1) / kStretch);
        tbb::parallel_for(size_t{0}, stretches.size(),
                          [&](size_t k) { findIn(search, all, k * kStretch, stretches[k]); });
    };
    const ListReading outside = outsideOf(mesh), inside = insideOf(mesh);
    searchIn({outside.vertices(), outside.indices(), wanted.both_sides, {}}, outside_);
    near_.clear();
    if (near == nullptr) {
        searchIn({inside.vertices(), inside.indices(), false, {}}, inside_);
    } else {
        const gl::BufferReading cells(near->cells);
        searchIn({inside.vertices(), inside.indices(), false, cells.as<uint32_t>()}, inside_);
        const auto& header = gl::BufferReading(near->indices).as<NearFaces::Header>()[0];
        const ListReading finer(near->vertices, near->indices, header.first, header.count);
        searchIn({finer.vertices(), finer.indices(), false, {}}, near_);
    }
    for (std::vector<Found>* stretches : {&outside_, &inside_, &near_})
        tbb::parallel_for(size_t{0}, stretches->size(), [&](size_t k) {
            Found& found = (*stretches)[k];
            found.candidates.keepSeen(nearest_, found.indices[0]);
        });
    collect(&SeenList::exterior, outside_);
    collect(&SeenList::interior, inside_);
    collect(&SeenList::near, near_);
}

void SeenTriangles::collect(TriangleList SeenList::*side, const std::vector<Found>& stretches) {
    for (size_t k = 0; k < lists_.size(); ++k)
        (lists_[k].*side)
            .fill(
                stretches, [&](const Found& found) -> const auto& { return found.indices[k]; });
}

}  // namespace demolish::engine
