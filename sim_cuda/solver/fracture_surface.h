// SPDX-License-Identifier: Apache-2.0
// The surface that fracture opens: which faces and cracks show, how fresh ones are bent, how the outside
// follows (outside_surface.h), and what is written for drawing.
//
// Use, from Solver::exportFrame():
//   FractureSurface<Backend> surface(backend, concatenateGeometry(setup.bodies));    once
//   if (fracture changed)                     surface.update(fracture);
//   if (fracture changed || streams_fresh)    surface.write(streams, fragment, size, streams_fresh);
//   save / restore: saveState() and restoreState(), and write() with the next frame; back to the start:
//   reset().
// Bonds stand in the order of the bodies and of BreakableBody::bonds. Nothing waits for the device and no
// count is read back. All is gathered, so it has the same bits on every device; what a frame shows depends on
// the order in which faces were exposed from update to update, because faces that showed before never move
// again.
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
#include "sim_cuda/kernels/wave_pool_vertices.h"
#include "sim_cuda/kernels/write_draw_commands.h"
#include "sim_cuda/kernels/write_exterior_indices.h"
#include "sim_cuda/kernels/write_interior_indices.h"
#include "sim_cuda/kernels/write_interior_vertices.h"
#include "sim_cuda/solver/concatenate_geometry.h"
#include "sim_cuda/solver/marked_list.h"
#include "sim_cuda/solver/outside_surface.h"
#include "sim_cuda/solver/piece_planes.h"

namespace demolish {

template <class Backend>
class FractureSurface {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend and copies of the interior geometry on its device. `smooth` false:
    /// nothing is bent, everything is drawn as the cells are.
    FractureSurface(Backend& backend, const SceneGeometry& scene, bool smooth = true);

    /// Marks what shows now and bends the faces that did not show at the last update.
    void update(const Fracture& fracture);

    /// Fills the vertices, indices and commands, each unless its stream is empty, as of the last update;
    /// `fragment` and `size` are those of that update. What would not fit is left out: streamSizes() always
    /// fits.
    void write(const RenderStreams& streams, Span<const uint32_t> fragment, Span<const uint32_t> size,
               bool streams_fresh);
    /// Fills crack_edges unless that stream is empty; `fragment` as write() has it; opening: m, of each bond.
    void writeCracks(const RenderStreams& streams, Span<const uint32_t> fragment, Span<const float> opening);
    /// Instead of write(), where nothing has changed.
    void tellUnchanged(const RenderStreams& streams) { outside_.tellUnchanged(streams); }

    /// Everything whole and at rest again.
    void reset();

    /// What changes from update to update, for snapshots: face states, bent positions and the outside's
    /// points. Waits for the device.
    std::vector<std::byte> saveState();
    /// Restores saveState()'s bytes, taken on the same scene, and brings counts up to date with fracture as
    /// it was then.
    void restoreState(const std::vector<std::byte>& state, const Fracture& fracture);

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
    void bendNewFaces(const Fracture& fracture);
    void chooseExterior(Span<const uint32_t> fragment);
    void makeExteriorWhole();
    void writeExterior(Span<uint32_t> outside);
    void countShown(const Fracture& fracture);

    Backend& backend_;
    // static
    bool smooth_;
    Buffer<InteriorFace> faces_;
    Buffer<uint32_t> face_vertices_, face_of_vertex_;
    Buffer<uint16_t> face_indices_;
    Buffer<ExteriorTriangle> exterior_triangles_;
    Buffer<uint32_t> exterior_cells_, exterior_parts_, exterior_rim_;
    size_t cells_;
    Buffer<CrackEdge> crack_edges_;
    Buffer<uint32_t> corner_start_, corner_face_, corner_next_, corner_previous_;
    Buffer<Float3> rest_;
    Buffer<float> spacing_, waves_;
    Buffer<uint8_t> surface_distance_;  ///< of pool vertices, in edges
    // changing
    Buffer<uint8_t> face_state_;
    MarkedList<Backend> movable_;                  ///< pool vertices
    Buffer<uint32_t> pieces_there_;                ///< PiecesThere::word() of each of those
    Buffer<uint32_t> smallest_there_;              ///< slot of the smallest piece there, likewise
    Buffer<uint32_t> steps_moved_;                 ///< of smoothing
    Buffer<uint8_t> uncut_;                        ///< triangles of the mesh
    Buffer<Float3> position_, previous_position_;  ///< alike between updates
    Buffer<uint32_t> first_vertex_, first_index_, first_exterior_,
        crack_place_;  ///< exclusive scans, one longer than what they count
    OutsideSurface<Backend> outside_;
    PiecePlanes<Backend> piece_planes_;
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

template <class T>
std::vector<T> readFrom(const std::byte*& at, size_t count) {
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), at, count * sizeof(T));
    at += count * sizeof(T);
    return values;
}
template <class T>
void appendBytes(const std::vector<T>& values, std::vector<std::byte>& to) {
    const auto* first = reinterpret_cast<const std::byte*>(values.data());
    to.insert(to.end(), first, first + values.size() * sizeof(T));
}

template <class Backend>
FractureSurface<Backend>::FractureSurface(Backend& backend, const SceneGeometry& scene, bool smooth)
    : backend_(backend),
      smooth_(smooth),
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
      waves_(backend.uploaded(scene.pool_waves)),
      surface_distance_(backend.template allocate<uint8_t>(rest_.size())),
      face_state_(backend.template allocate<uint8_t>(faces_.size())),
      movable_(backend, rest_.size()),
      pieces_there_(backend.template allocate<uint32_t>(rest_.size())),
      smallest_there_(backend.template allocate<uint32_t>(rest_.size())),
      steps_moved_(backend.template allocate<uint32_t>(kMostSmoothingSteps)),
      uncut_(backend.template allocate<uint8_t>(exterior_triangles_.size())),
      position_(backend.uploaded(scene.geometry.pool)),
      previous_position_(backend.uploaded(scene.geometry.pool)),
      first_vertex_(backend.template allocate<uint32_t>(faces_.size() + 1)),
      first_index_(backend.template allocate<uint32_t>(faces_.size() + 1)),
      first_exterior_(backend.template allocate<uint32_t>(exterior_triangles_.size() + 1)),
      crack_place_(backend.template allocate<uint32_t>(crack_edges_.size() + 1)),
      outside_(backend, scene.geometry, cells_),
      piece_planes_(backend, scene) {
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
void FractureSurface<Backend>::update(const Fracture& fracture) {
    countShown(fracture);
    if (!smooth_) return;
    outside_.update(fracture, position_.span(), previous_position_.span());
    bendNewFaces(fracture);
}

template <class Backend>
void FractureSurface<Backend>::countShown(const Fracture& fracture) {
    const size_t faces = faces_.size(), cracks = crack_edges_.size();
    backend_.forEach(faces,
                     MarkExposedFaces{faces_.view(), fracture.fragment, face_state_.span(),
                                      first_vertex_.span(), first_index_.span()},
                     "mark exposed faces");
    backend_.forEach(
        cracks,
        MarkShownCracks{crack_edges_.view(), fracture.fragment, fracture.bond_broken, crack_place_.span()},
        "mark shown cracks");

    backend_.exclusiveScan(first_vertex_.view().part(0, faces), first_vertex_.span());
    backend_.exclusiveScan(first_index_.view().part(0, faces), first_index_.span());
    backend_.exclusiveScan(crack_place_.view().part(0, cracks), crack_place_.span());
    chooseExterior(fracture.fragment);
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
void FractureSurface<Backend>::bendNewFaces(const Fracture& fracture) {
    backend_.forEach(rest_.size(),
                     ChooseMovableVertices{corners(), faces_.view(), face_state_.view(),
                                           surface_distance_.view(), fracture.fragment, fracture.size,
                                           movable_.marks(), pieces_there_.span(), smallest_there_.span()},
                     "choose movable vertices");
    movable_.gather();
    backend_.fill(steps_moved_.span(), 0u);
    static_assert(kMostSmoothingSteps % 2 == 0, "it ends where it has begun");
    movable_.forEachInSteps(kMostSmoothingSteps,
                            RelaxPoolVertices{corners(),
                                              face_state_.view(),
                                              pieces_there_.view(),
                                              rest_.view(),
                                              spacing_.view(),
                                              {position_.span(), previous_position_.span()},
                                              {steps_moved_.span()}},
                            "relax pool vertices");
    const PieceShapes pieces =
        piece_planes_.find(fracture, faces_.view(), face_vertices_.view(), face_state_.view(), rest_.view());
    movable_.forEach(PlanePoolVertices{pieces, smallest_there_.view(), surface_distance_.view(), rest_.view(),
                                       spacing_.view(), position_.span(), previous_position_.span()},
                     "plane pool vertices");
    movable_.forEach(WavePoolVertices{corners(), face_state_.view(), surface_distance_.view(),
                                      pieces_there_.view(), rest_.view(), spacing_.view(), waves_.view(),
                                      previous_position_.view(), position_.span()},
                     "wave pool vertices");
    movable_.forEach(RoughenPoolVertices{surface_distance_.view(), pieces_there_.view(), rest_.view(),
                                         spacing_.view(), position_.span(), previous_position_.span()},
                     "roughen pool vertices");
}

template <class Backend>
void FractureSurface<Backend>::write(const RenderStreams& streams, Span<const uint32_t> fragment,
                                     Span<const uint32_t> size, bool streams_fresh) {
    outside_.write(streams, streams_fresh);
    const auto span = [](const auto& stream) { return Span(stream.data, stream.data ? stream.capacity : 0); };
    const Span<SurfaceVertex> vertices = span(streams.interior_vertices);
    const Span<uint32_t> indices = span(streams.interior_indices), outside = span(streams.exterior_indices);
    const Span<DrawCommands> commands = span(streams.commands);
    if (!vertices.empty())
        backend_.forEach(face_vertices_.size(),
                         WriteInteriorVertices{faces_.view(), face_of_vertex_.view(), face_vertices_.view(),
                                               face_state_.view(), first_vertex_.view(), fragment, size,
                                               corners(), surface_distance_.view(), spacing_.view(),
                                               position_.view(), vertices, smooth_},
                         "write interior vertices");
    if (!indices.empty())
        backend_.forEach(
            faces_.size(),
            WriteInteriorIndices{faces_.view(), face_indices_.view(), face_state_.view(),
                                 first_vertex_.view(), first_index_.view(), vertices.size(), indices},
            "write interior indices");
    if (!outside.empty()) writeExterior(outside);
    if (!commands.empty())
        backend_.forEach(
            1,
            WriteDrawCommands{first_index_.view(), crack_place_.view(), first_exterior_.view(),
                              indices.size(), streams.crack_edges.capacity, outside.size(), commands},
            "write draw commands");
}

template <class Backend>
void FractureSurface<Backend>::writeCracks(const RenderStreams& streams, Span<const uint32_t> fragment,
                                           Span<const float> opening) {
    const Stream<CrackLine>& lines = streams.crack_edges;
    if (lines.data != nullptr)
        outside_.writeCracks(crack_place_.view(), fragment, opening, Span(lines.data, lines.capacity));
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
    backend_.copy(rest_.view(), previous_position_.span());
    outside_.reset();
    backend_.fill(face_state_.span(), kFaceHidden);
    backend_.fill(first_vertex_.span(), 0u);
    backend_.fill(first_index_.span(), 0u);
    backend_.fill(crack_place_.span(), 0u);
    makeExteriorWhole();
}

template <class Backend>
std::vector<std::byte> FractureSurface<Backend>::saveState() {
    std::vector<std::byte> state;
    appendBytes(backend_.downloaded(position_.view()), state);
    appendBytes(backend_.downloaded(face_state_.view()), state);
    appendBytes(outside_.saveState(), state);
    return state;
}

template <class Backend>
void FractureSurface<Backend>::restoreState(const std::vector<std::byte>& state, const Fracture& fracture) {
    const std::byte* at = state.data();
    const auto positions = readFrom<Float3>(at, position_.size());
    const auto faces = readFrom<uint8_t>(at, face_state_.size());
    const auto outside = readFrom<Float3>(at, outside_.stateSize());
    backend_.upload(position_.span(), positions.data(), positions.size());
    backend_.copy(position_.view(), previous_position_.span());
    backend_.upload(face_state_.span(), faces.data(), faces.size());
    outside_.restoreState(outside, fracture);
    countShown(fracture);
    backend_.synchronize();  // the host copies go out of scope
}

}  // namespace demolish
