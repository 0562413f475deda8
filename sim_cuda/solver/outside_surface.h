// SPDX-License-Identifier: Apache-2.0
// Where the points of the outside stand once it has cracked: lines of cracks lose the teeth of the cells, and
// what lies round them follows along the surface. Drawing alone: nothing here acts on the bodies.
//
//   link rims -> wanted places: junctions, lines; borders of fragments first, then hairlines
//     -> which points move -> spread the shift -> lay on the mesh -> untangle what turned over -> tell the
//     pool
//
// A line that bounded fragments at the last update stays where it is for good; hairlines go on moving. All is
// gathered: the same bits on every device.
#pragma once
#include <utility>
#include <vector>

#include "sim_cuda/kernels/link_rims.h"
#include "sim_cuda/kernels/slide_junctions.h"
#include "sim_cuda/kernels/slide_rims.h"
#include "sim_cuda/kernels/spread_shift.h"
#include "sim_cuda/kernels/start_shift.h"
#include "sim_cuda/kernels/untangle_points.h"
#include "sim_cuda/kernels/write_crack_list.h"
#include "sim_cuda/kernels/write_exterior_vertices.h"
#include "sim_cuda/solver/marked_list.h"

namespace demolish {

/// What the solver knows when fracture has changed.
struct Fracture {
    Span<const uint32_t> fragment;  ///< of each particle: below their number, equal exactly in a fragment
    Span<const uint32_t> size;      ///< cells, by that number
    Span<const uint8_t> bond_broken;
};

template <class Backend>
class OutsideSurface {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    /// Keeps a reference to the backend and copies of the outside's geometry on its device.
    OutsideSurface(Backend& backend, const FractureGeometry& geometry, size_t cells);

    /// Moves points for what has cracked since the last update; writes them into `pool` and `pool_before`,
    /// which are alike.
    void update(const Fracture& fracture, Span<Float3> pool, Span<Float3> pool_before);

    /// Fills exterior_vertices and exterior_chunks, each unless its stream is empty.
    void write(const RenderStreams& streams, bool streams_fresh);
    /// When nothing is written: no chunk is.
    void tellUnchanged(const RenderStreams& streams);

    /// Writes which of the crack edges show; place: exclusive scan of those that do; opening: m, of bonds.
    void writeCracks(Span<const uint32_t> place, Span<const uint32_t> fragment, Span<const float> opening,
                     Span<CrackLine> out) {
        backend_.forEach(edges_.size(),
                         WriteCrackList{place, mesh(), home_.view(), link_.view(), position_.view(), fragment,
                                        opening, out},
                         "write crack list");
    }

    void reset();
    /// m, what changes from update to update: positions of all points, then where they set out for last.
    /// Waits for the device.
    std::vector<Float3> saveState();
    size_t stateSize() const { return 2 * points_.size(); }
    /// saveState()'s numbers, with fracture as it was then. `state` may go out of scope after the next
    /// synchronize().
    void restoreState(const std::vector<Float3>& state, const Fracture& fracture);

  private:
    OutsideMesh mesh() const {
        return {points_.view(),          triangles_.view(),     corner_start_.view(), corner_next_.view(),
                corner_previous_.view(), corner_weight_.view(), corner_part_.view(),  crack_start_.view(),
                cracks_.view(),          edges_.view()};
    }
    void linkRims(const Fracture& fracture);
    void chooseLines(RimKind kind, const Fracture& fracture);
    void chooseMoving();
    void spread();
    void untangle();

    Backend& backend_;
    // static
    Buffer<OutsidePoint> points_;
    Buffer<MeshTriangle> triangles_;
    Buffer<uint32_t> corner_start_, corner_next_, corner_previous_;
    Buffer<float> corner_weight_;
    Buffer<Vec4<float>> corner_part_;
    Buffer<uint32_t> crack_start_;
    Buffer<PointCrack> cracks_;
    Buffer<CrackEdge> edges_;
    Buffer<uint32_t> border_;  ///< points at which crack edges end
    Buffer<SurfaceVertex> exterior_;
    Buffer<ExteriorHome> home_;
    Buffer<Float3> rest_;
    // changing
    Buffer<RimLink> link_;
    Buffer<Float3> position_, position_before_;  ///< alike between updates
    Buffer<Float3> place_, tried_, start_;       ///< wanted now, set out for last, before this update
    Buffer<Float3> shift_, shift_before_;        ///< 0 between updates
    Buffer<uint32_t> stirred_;                   ///< bits of cells
    Buffer<uint8_t> changed_;  ///< points, since the last write into streams that were not fresh
    Buffer<uint32_t> chunk_;
    Buffer<uint32_t> widened_;
    Buffer<uint32_t> steps_moved_;  ///< of untangling, then of taking back
    MarkedList<Backend> moving_, tangled_;
};

inline std::vector<uint32_t> borderPoints(const FractureGeometry& geometry) {
    std::vector<uint32_t> border;
    for (uint32_t p = 0; p < geometry.points.size(); ++p)
        if (geometry.point_crack_start[p + 1] > geometry.point_crack_start[p]) border.push_back(p);
    return border;
}
inline std::vector<Float3> restPoints(const FractureGeometry& geometry) {
    std::vector<Float3> rest;
    rest.reserve(geometry.points.size());
    for (const OutsidePoint& point : geometry.points) rest.push_back(point.position);
    return rest;
}

template <class Backend>
OutsideSurface<Backend>::OutsideSurface(Backend& backend, const FractureGeometry& geometry, size_t cells)
    : backend_(backend),
      points_(backend.uploaded(geometry.points)),
      triangles_(backend.uploaded(geometry.mesh_triangles)),
      corner_start_(backend.uploaded(geometry.point_corner_start)),
      corner_next_(backend.uploaded(geometry.point_corner_next)),
      corner_previous_(backend.uploaded(geometry.point_corner_previous)),
      corner_weight_(backend.template allocate<float>(corner_next_.size())),
      corner_part_(backend.template allocate<Vec4<float>>(corner_next_.size())),
      crack_start_(backend.uploaded(geometry.point_crack_start)),
      cracks_(backend.uploaded(geometry.point_cracks)),
      edges_(backend.uploaded(geometry.crack_edges)),
      border_(backend.uploaded(borderPoints(geometry))),
      exterior_(backend.uploaded(geometry.exterior)),
      home_(backend.uploaded(geometry.exterior_home)),
      rest_(backend.uploaded(restPoints(geometry))),
      link_(backend.template allocate<RimLink>(points_.size())),
      position_(backend.uploaded(restPoints(geometry))),
      position_before_(backend.uploaded(restPoints(geometry))),
      place_(backend.template allocate<Float3>(points_.size())),
      tried_(backend.uploaded(restPoints(geometry))),
      start_(backend.template allocate<Float3>(points_.size())),
      shift_(backend.template allocate<Float3>(points_.size())),
      shift_before_(backend.template allocate<Float3>(points_.size())),
      stirred_(backend.template allocate<uint32_t>(cells)),
      changed_(backend.template allocate<uint8_t>(points_.size())),
      chunk_(backend.template allocate<uint32_t>(exteriorChunks(exterior_.size()))),
      widened_(backend.template allocate<uint32_t>(points_.size())),
      steps_moved_(backend.template allocate<uint32_t>(Untangle::kSteps + TakeBack::kSteps)),
      moving_(backend, points_.size()),
      tangled_(backend, points_.size()) {
    backend_.forEach(points_.size(), WeighCorners{mesh(), corner_weight_.span()}, "weigh corners");
    backend_.forEach(points_.size(), MeasureParts{mesh(), corner_part_.span()}, "measure parts");
    backend_.synchronize();  // host copies go out of scope
}

template <class Backend>
void OutsideSurface<Backend>::update(const Fracture& fracture, Span<Float3> pool, Span<Float3> pool_before) {
    linkRims(fracture);
    chooseLines(RimKind::kApart, fracture);
    chooseLines(RimKind::kHairline, fracture);
    chooseMoving();
    spread();
    const LayOnOutside lay{mesh()};
    moving_.forEach(PlacePoints{lay, shift_.view(), start_.span(), position_.span(), position_before_.span()},
                    "place points");
    untangle();
    moving_.forEach(FinishPoints{mesh(), position_.view(), position_before_.span(), shift_.span(),
                                 shift_before_.span(), pool, pool_before, changed_.span()},
                    "finish points");
}

template <class Backend>
void OutsideSurface<Backend>::linkRims(const Fracture& fracture) {
    backend_.forEach(border_.size(),
                     LinkRims{mesh(), border_.view(), fracture.fragment, fracture.size, fracture.bond_broken,
                              link_.span(), position_.view(), place_.span()},
                     "link rims");
}

template <class Backend>
void OutsideSurface<Backend>::chooseLines(RimKind kind, const Fracture& fracture) {
    const RimLines lines{points_.view(), link_.view(), place_.view(), kind};
    backend_.forEach(
        border_.size(),
        SlideJunctions{mesh(), lines, border_.view(), fracture.fragment, fracture.bond_broken, place_.span()},
        "slide junctions");
    backend_.forEach(border_.size(), SlideRims{mesh(), lines, border_.view(), place_.span()}, "slide rims");
}

template <class Backend>
void OutsideSurface<Backend>::chooseMoving() {
    backend_.fill(stirred_.span(), 0u);
    backend_.forEach(border_.size(),
                     StartShift{mesh(), border_.view(), link_.view(), place_.view(), position_.view(),
                                tried_.span(), shift_.span(), shift_before_.span(), stirred_.span()},
                     "start shift");
    backend_.forEach(edges_.size(), StirNeighbours{edges_.view(), stirred_.span()}, "stir neighbours");
    backend_.forEach(
        points_.size(),
        ChooseMovingPoints{mesh(), link_.view(), shift_.view(), stirred_.view(), moving_.marks()},
        "choose moving points");
    moving_.gather();
}

template <class Backend>
void OutsideSurface<Backend>::spread() {
    static_assert(SpreadShift::kSteps % 2 == 0, "it ends where it has begun");
    moving_.forEachInSteps(SpreadShift::kSteps,
                           SpreadShift{mesh(), link_.view(), {shift_.span(), shift_before_.span()}},
                           "spread shift");
}

template <class Backend>
void OutsideSurface<Backend>::untangle() {
    const PartsOfOutside parts{mesh()};
    const LayOnOutside lay{mesh()};
    backend_.fill(tangled_.marks(), 0u);
    backend_.fill(widened_.span(), 0u);
    moving_.forEach(MarkTangled{parts, position_.view(), tangled_.marks()}, "mark tangled");
    const Span<const uint32_t> moves = std::as_const(moving_).marks();
    moving_.forEach(WidenTangled{mesh(), std::as_const(tangled_).marks(), moves, widened_.span()},
                    "widen tangled");
    moving_.forEach(WidenTangled{mesh(), widened_.view(), moves, tangled_.marks()}, "widen tangled");
    tangled_.gather();
    backend_.fill(steps_moved_.span(), 0u);
    static_assert(Untangle::kSteps % 2 == 0 && TakeBack::kSteps % 2 == 0, "they end where they have begun");
    const TwoCopies copies{position_.span(), position_before_.span()};
    const Span<uint32_t> untangling = steps_moved_.span().part(0, Untangle::kSteps),
                         taking_back = steps_moved_.span().part(Untangle::kSteps, TakeBack::kSteps);
    tangled_.forEachInSteps(Untangle::kSteps, Untangle{parts, lay, link_.view(), moves, copies, {untangling}},
                            "untangle");
    moving_.forEachInSteps(TakeBack::kSteps, TakeBack{parts, lay, start_.view(), copies, {taking_back}},
                           "take back");
}

template <class Backend>
void OutsideSurface<Backend>::write(const RenderStreams& streams, bool streams_fresh) {
    if (streams.exterior_vertices.data == nullptr) return tellUnchanged(streams);
    const Span<SurfaceVertex> out(streams.exterior_vertices.data, streams.exterior_vertices.capacity);
    backend_.fill(chunk_.span(), streams_fresh ? 1u : 0u);
    if (!streams_fresh)
        backend_.forEach(home_.size(), MarkChangedChunks{home_.view(), changed_.view(), chunk_.span()},
                         "mark changed chunks");
    backend_.forEach(
        home_.size(),
        WriteExteriorVertices{exterior_.view(), home_.view(), mesh(), position_.view(), chunk_.view(), out},
        "write exterior vertices");
    if (!streams_fresh) backend_.fill(changed_.span(), uint8_t{0});
    if (const auto& chunks = streams.exterior_chunks;
        chunks.data != nullptr && chunks.capacity >= chunk_.size())
        backend_.copy(chunk_.view(), Span(chunks.data, chunk_.size()));
}

template <class Backend>
void OutsideSurface<Backend>::tellUnchanged(const RenderStreams& streams) {
    if (const auto& chunks = streams.exterior_chunks; chunks.data != nullptr)
        backend_.fill(Span(chunks.data, chunks.capacity), 0u);
}

template <class Backend>
void OutsideSurface<Backend>::reset() {
    backend_.copy(rest_.view(), position_.span());
    backend_.copy(rest_.view(), position_before_.span());
    backend_.copy(rest_.view(), tried_.span());
    backend_.fill(link_.span(), RimLink{});
    backend_.fill(changed_.span(), uint8_t{1});
}

template <class Backend>
std::vector<Float3> OutsideSurface<Backend>::saveState() {
    std::vector<Float3> state = backend_.downloaded(position_.view());
    const std::vector<Float3> tried = backend_.downloaded(tried_.view());
    state.insert(state.end(), tried.begin(), tried.end());
    return state;
}

template <class Backend>
void OutsideSurface<Backend>::restoreState(const std::vector<Float3>& state, const Fracture& fracture) {
    const size_t points = points_.size();
    backend_.upload(position_.span(), state.data(), points);
    backend_.copy(position_.view(), position_before_.span());
    backend_.upload(tried_.span(), state.data() + points, points);
    linkRims(fracture);
    backend_.fill(changed_.span(), uint8_t{1});
}

}  // namespace demolish
