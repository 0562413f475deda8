// SPDX-License-Identifier: Apache-2.0
// The surface that fracture opens: which faces and cracks show, how fresh ones are bent, and what is written
// for drawing.
//
// Use, from Solver::exportFrame():
//   FractureSurface<Backend> surface(backend, concatenateGeometry(setup.bodies));    once
//   if (fracture changed)                     surface.update(fragment, bond_broken);
//   if (fracture changed || streams_fresh)    surface.write(streams, fragment);
//   save / restore: saveState() and restoreState(), and write() with the next frame; back to the start:
//   reset().
// `fragment` holds each particle's slot (any number that is equal exactly within a fragment), `bond_broken`
// one byte per bond (1: broken) in the order of the bodies and of BreakableBody::bonds. Nothing waits for the
// device and no count is read back. All is gathered, so it has the same bits on every device; what a frame
// shows depends on the order in which faces were exposed from update to update, because faces that showed
// before never move again.
#pragma once
#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/kernels/choose_movable_vertices.h"
#include "sim_cuda/kernels/mark_exposed_faces.h"
#include "sim_cuda/kernels/mark_shown_cracks.h"
#include "sim_cuda/kernels/relax_pool_vertices.h"
#include "sim_cuda/kernels/roughen_pool_vertices.h"
#include "sim_cuda/kernels/spread_surface_distance.h"
#include "sim_cuda/kernels/write_crack_list.h"
#include "sim_cuda/kernels/write_draw_commands.h"
#include "sim_cuda/kernels/write_exterior_indices.h"
#include "sim_cuda/kernels/write_interior_indices.h"
#include "sim_cuda/kernels/write_interior_vertices.h"
#include "sim_cuda/solver/concatenate_geometry.h"

namespace demolish {

/// Laplacian steps on newly exposed faces; more would invert the tips of single cells (geometry.md 4 d).
inline constexpr int kRelaxationSteps = 5;

template <class Backend>
class FractureSurface {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend and copies of the interior geometry on its device.
    FractureSurface(Backend& backend, const SceneGeometry& scene);

    /// Marks what shows now and bends the faces that did not show at the last update.
    void update(Span<const uint32_t> fragment, Span<const uint8_t> bond_broken);

    /// Fills interior_vertices, interior_indices, exterior_indices, crack_edges and commands, each unless its
    /// stream is empty, as of the last update; `fragment` is the one of that update. What would not fit is
    /// left out: streamSizes() always fits.
    void write(const RenderStreams& streams, Span<const uint32_t> fragment);

    /// Everything whole and at rest again.
    void reset();

    /// What changes from update to update, for snapshots: face states and bent positions. Waits for the
    /// device.
    std::vector<std::byte> saveState();
    /// Restores saveState()'s bytes, taken on the same scene, and brings counts up to date with `fragment`
    /// and `bond_broken` as they were then.
    void restoreState(const std::vector<std::byte>& state, Span<const uint32_t> fragment,
                      Span<const uint8_t> bond_broken);

    /// m, pool positions as drawn, by pool id (tests, export).
    Span<const Float3> positions() const { return position_.view(); }

  private:
    PoolCorners corners() const {
        return {corner_start_.view(), corner_face_.view(), corner_next_.view(), corner_previous_.view()};
    }
    void measureSurfaceDistance(const std::vector<uint8_t>& on_surface);
    ExteriorMesh exterior() const {
        return {exterior_triangles_.view(), exterior_cells_.view(), exterior_parts_.view(),
                exterior_rim_.view()};
    }
    void bendNewFaces();
    void chooseExterior(Span<const uint32_t> fragment);
    void makeExteriorWhole();
    void writeExterior(Span<uint32_t> outside);
    void countShown(Span<const uint32_t> fragment, Span<const uint8_t> bond_broken);

    Backend& backend_;
    // static
    Buffer<InteriorFace> faces_;
    Buffer<uint32_t> face_vertices_, face_of_vertex_;
    Buffer<uint16_t> face_indices_;
    Buffer<ExteriorTriangle> exterior_triangles_;
    Buffer<uint32_t> exterior_cells_, exterior_parts_, exterior_rim_;
    size_t cells_;
    Buffer<CrackEdge> crack_edges_;
    Buffer<uint32_t> corner_start_, corner_face_, corner_next_, corner_previous_;
    Buffer<Float3> rest_;
    Buffer<float> spacing_;
    Buffer<uint8_t> surface_distance_;  ///< of pool vertices, in edges
    // changing
    Buffer<uint8_t> face_state_, movable_;
    Buffer<uint8_t> uncut_;  ///< triangles of the mesh
    Buffer<Float3> position_, previous_position_;
    Buffer<uint32_t> first_vertex_, first_index_, first_exterior_,
        crack_place_;  ///< exclusive scans, one longer than what they count
};

/// Which face each entry of face_vertices belongs to.
inline std::vector<uint32_t> faceOfVertex(const FractureGeometry& geometry) {
    std::vector<uint32_t> face_of_vertex(geometry.face_vertices.size());
    for (uint32_t f = 0; f < geometry.faces.size(); ++f)
        for (uint32_t v = 0; v < geometry.faces[f].vertex_count; ++v)
            face_of_vertex[geometry.faces[f].first_vertex + v] = f;
    return face_of_vertex;
}

/// Cells that have a part of the outside have numbers below this.
inline size_t cellsOf(const FractureGeometry& geometry) {
    const auto& cells = geometry.exterior_cells;
    return cells.empty() ? 0 : size_t{*std::max_element(cells.begin(), cells.end())} + 1;
}

template <class Backend>
FractureSurface<Backend>::FractureSurface(Backend& backend, const SceneGeometry& scene)
    : backend_(backend),
      faces_(backend.uploaded(scene.geometry.faces)),
      face_vertices_(backend.uploaded(scene.geometry.face_vertices)),
      face_of_vertex_(backend.uploaded(faceOfVertex(scene.geometry))),
      face_indices_(backend.uploaded(scene.geometry.face_indices)),
      exterior_triangles_(backend.uploaded(scene.geometry.exterior_triangles)),
      exterior_cells_(backend.uploaded(scene.geometry.exterior_cells)),
      exterior_parts_(backend.uploaded(scene.geometry.exterior_indices)),
      exterior_rim_(backend.uploaded(scene.geometry.exterior_rim)),
      cells_(cellsOf(scene.geometry)),
      crack_edges_(backend.uploaded(scene.geometry.crack_edges)),
      corner_start_(backend.uploaded(scene.geometry.pool_corner_start)),
      corner_face_(backend.uploaded(scene.geometry.pool_corner_face)),
      corner_next_(backend.uploaded(scene.geometry.pool_corner_next)),
      corner_previous_(backend.uploaded(scene.geometry.pool_corner_previous)),
      rest_(backend.uploaded(scene.geometry.pool)),
      spacing_(backend.uploaded(scene.pool_spacing)),
      surface_distance_(backend.template allocate<uint8_t>(rest_.size())),
      face_state_(backend.template allocate<uint8_t>(faces_.size())),
      movable_(backend.template allocate<uint8_t>(rest_.size())),
      uncut_(backend.template allocate<uint8_t>(exterior_triangles_.size())),
      position_(backend.uploaded(scene.geometry.pool)),
      previous_position_(backend.template allocate<Float3>(rest_.size())),
      first_vertex_(backend.template allocate<uint32_t>(faces_.size() + 1)),
      first_index_(backend.template allocate<uint32_t>(faces_.size() + 1)),
      first_exterior_(backend.template allocate<uint32_t>(exterior_triangles_.size() + 1)),
      crack_place_(backend.template allocate<uint32_t>(crack_edges_.size() + 1)) {
    makeExteriorWhole();
    measureSurfaceDistance(scene.geometry.pool_on_surface);
}

template <class Backend>
void FractureSurface<Backend>::measureSurfaceDistance(const std::vector<uint8_t>& on_surface) {
    std::vector<uint8_t> start(on_surface.size());
    for (size_t v = 0; v < start.size(); ++v) start[v] = on_surface[v] != 0 ? uint8_t{0} : kInnerDistance;
    Buffer<uint8_t> before = backend_.uploaded(start);
    for (uint8_t ring = 1; ring < kInnerDistance; ++ring) {
        backend_.forEach(start.size(),
                         SpreadSurfaceDistance{corners(), before.view(), surface_distance_.span()},
                         "spread surface distance");
        std::swap(before, surface_distance_);
    }
    std::swap(before, surface_distance_);
    backend_.synchronize();  // `before` goes out of scope
}

template <class Backend>
void FractureSurface<Backend>::update(Span<const uint32_t> fragment, Span<const uint8_t> bond_broken) {
    countShown(fragment, bond_broken);
    bendNewFaces();
}

template <class Backend>
void FractureSurface<Backend>::countShown(Span<const uint32_t> fragment, Span<const uint8_t> bond_broken) {
    const size_t faces = faces_.size(), cracks = crack_edges_.size();
    backend_.forEach(faces,
                     MarkExposedFaces{faces_.view(), fragment, face_state_.span(), first_vertex_.span(),
                                      first_index_.span()},
                     "mark exposed faces");
    backend_.forEach(cracks, MarkShownCracks{crack_edges_.view(), fragment, bond_broken, crack_place_.span()},
                     "mark shown cracks");

    backend_.exclusiveScan(first_vertex_.view().part(0, faces), first_vertex_.span());
    backend_.exclusiveScan(first_index_.view().part(0, faces), first_index_.span());
    backend_.exclusiveScan(crack_place_.view().part(0, cracks), crack_place_.span());
    chooseExterior(fragment);
}

template <class Backend>
void FractureSurface<Backend>::chooseExterior(Span<const uint32_t> fragment) {
    const size_t triangles = exterior_triangles_.size();
    backend_.forEach(triangles, MarkUncut{exterior(), fragment, uncut_.span()}, "mark uncut triangles");
    backend_.forEach(triangles, CountExterior{exterior(), uncut_.view(), first_exterior_.span()},
                     "count exterior");
    backend_.exclusiveScan(first_exterior_.view().part(0, triangles), first_exterior_.span());
}

template <class Backend>
void FractureSurface<Backend>::makeExteriorWhole() {
    const Buffer<uint32_t> fragment = backend_.uploaded(std::vector<uint32_t>(cells_, 0));
    chooseExterior(fragment.view());
    backend_.synchronize();  // `fragment` goes out of scope
}

template <class Backend>
void FractureSurface<Backend>::bendNewFaces() {
    const size_t vertices = rest_.size();
    backend_.forEach(
        vertices,
        ChooseMovableVertices{corners(), face_state_.view(), surface_distance_.view(), movable_.span()},
        "choose movable vertices");
    for (int step = 0; step < kRelaxationSteps; ++step) {
        std::swap(position_, previous_position_);
        backend_.forEach(vertices,
                         RelaxPoolVertices{corners(), face_state_.view(), movable_.view(), rest_.view(),
                                           previous_position_.view(), spacing_.view(), position_.span()},
                         "relax pool vertices");
    }
    backend_.forEach(vertices,
                     RoughenPoolVertices{movable_.view(), surface_distance_.view(), rest_.view(),
                                         spacing_.view(), position_.span()},
                     "roughen pool vertices");
}

template <class Backend>
void FractureSurface<Backend>::write(const RenderStreams& streams, Span<const uint32_t> fragment) {
    const auto span = [](const auto& stream) { return Span(stream.data, stream.data ? stream.capacity : 0); };
    const Span<SurfaceVertex> vertices = span(streams.interior_vertices);
    const Span<uint32_t> indices = span(streams.interior_indices), cracks = span(streams.crack_edges);
    const Span<uint32_t> outside = span(streams.exterior_indices);
    const Span<DrawCommands> commands = span(streams.commands);
    if (!vertices.empty())
        backend_.forEach(
            face_vertices_.size(),
            WriteInteriorVertices{faces_.view(), face_of_vertex_.view(), face_vertices_.view(),
                                  face_state_.view(), first_vertex_.view(), fragment, corners(),
                                  surface_distance_.view(), spacing_.view(), position_.view(), vertices},
            "write interior vertices");
    if (!indices.empty())
        backend_.forEach(
            faces_.size(),
            WriteInteriorIndices{faces_.view(), face_indices_.view(), face_state_.view(),
                                 first_vertex_.view(), first_index_.view(), vertices.size(), indices},
            "write interior indices");
    if (!outside.empty()) writeExterior(outside);
    if (!cracks.empty())
        backend_.forEach(crack_edges_.size(), WriteCrackList{crack_place_.view(), cracks},
                         "write crack list");
    if (!commands.empty())
        backend_.forEach(1,
                         WriteDrawCommands{first_index_.view(), crack_place_.view(), first_exterior_.view(),
                                           indices.size(), cracks.size(), outside.size(), commands},
                         "write draw commands");
}

template <class Backend>
void FractureSurface<Backend>::writeExterior(Span<uint32_t> outside) {
    constexpr uint32_t kThreads = Backend::kOnGpu ? 32 : 1;
    const size_t triangles = exterior_triangles_.size();
    const auto write = [&](auto kernel, uint32_t threads) {
        backend_.forEach(triangles * threads, kernel, "write exterior indices");
    };
    if (kThreads > 1 && exterior_parts_.size() > kThreads * triangles)
        write(WriteExteriorIndices<kThreads>{exterior(), uncut_.view(), first_exterior_.view(), outside},
              kThreads);
    else
        write(WriteExteriorIndices<1>{exterior(), uncut_.view(), first_exterior_.view(), outside}, 1);
}

template <class Backend>
void FractureSurface<Backend>::reset() {
    backend_.copy(rest_.view(), position_.span());
    backend_.fill(face_state_.span(), kFaceHidden);
    backend_.fill(first_vertex_.span(), 0u);
    backend_.fill(first_index_.span(), 0u);
    backend_.fill(crack_place_.span(), 0u);
    makeExteriorWhole();
}

template <class Backend>
std::vector<std::byte> FractureSurface<Backend>::saveState() {
    const size_t position_bytes = position_.size() * sizeof(Float3);
    std::vector<std::byte> state(position_bytes + face_state_.size());
    const std::vector<Float3> positions = backend_.downloaded(position_.view());
    const std::vector<uint8_t> faces = backend_.downloaded(face_state_.view());
    if (!positions.empty()) std::memcpy(state.data(), positions.data(), position_bytes);
    if (!faces.empty()) std::memcpy(state.data() + position_bytes, faces.data(), faces.size());
    return state;
}

template <class Backend>
void FractureSurface<Backend>::restoreState(const std::vector<std::byte>& state,
                                            Span<const uint32_t> fragment, Span<const uint8_t> bond_broken) {
    const size_t position_bytes = position_.size() * sizeof(Float3);
    std::vector<Float3> positions(position_.size());
    std::vector<uint8_t> faces(face_state_.size());
    if (!positions.empty()) std::memcpy(positions.data(), state.data(), position_bytes);
    if (!faces.empty()) std::memcpy(faces.data(), state.data() + position_bytes, faces.size());
    backend_.upload(position_.span(), positions.data(), positions.size());
    backend_.upload(face_state_.span(), faces.data(), faces.size());
    countShown(fragment, bond_broken);
    backend_.synchronize();  // the host copies go out of scope
}

}  // namespace demolish
