// SPDX-License-Identifier: Apache-2.0
// One frame written for drawing, into memory that the caller gives.
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "sim_cuda/api/particle_colour.h"
#include "sim_cuda/kernels/measure_openings.h"
#include "sim_cuda/kernels/write_colours.h"
#include "sim_cuda/kernels/write_particles.h"
#include "sim_cuda/solver/byte_stream.h"
#include "sim_cuda/solver/device_scene.h"
#include "sim_cuda/solver/fracture_surface.h"

namespace demolish {

struct MarkBrokenBonds {
    Span<const uint32_t> slot_of_bond;
    Span<const BondLink> link;
    Span<uint8_t> broken;
    DEM_FN void operator()(uint32_t b) const { broken[b] = isBonded(link[slot_of_bond[b]]) ? 0 : 1; }
};

/// Slots of the bodies' particles and of the projectiles, one each.
struct CopyFragments {
    Span<const uint32_t> from;
    Span<uint32_t> to;
    DEM_FN void operator()(uint32_t i) const { to[i] = from[i]; }
};

/// Owns the fracture surface and where waiting projectiles are drawn, and knows how far both are behind the
/// state. Bonds never heal, so that the number of broken ones says whether anything has changed.
template <class Backend, class Real>
class FrameExporter {
  public:
    using Scene = DeviceScene<Backend, Real>;

    FrameExporter(Backend& backend, const SceneSetup& setup, const SceneTables& tables)
        : surface_(backend, concatenateGeometry(setup.bodies), setup.params.smooth_cracks),
          broken_bonds_(backend.template allocate<uint8_t>(tables.slot_of_bond.size())),
          opening_(backend.template allocate<float>(tables.slot_of_bond.size())),
          waiting_(backend.template allocate<Vec4<Real>>(kMaxProjectiles)) {}

    /// As Solver::exportFrame; broken: bonds. Does not wait.
    void write(Scene& scene, const Projectiles& projectiles, uint32_t broken, const RenderStreams& streams,
               bool streams_fresh);

    void save(ByteStream& out);
    /// What save() has written, with the rest of the scene as it was then, clusters included.
    struct Saved {
        uint32_t broken = 0;  ///< bonds, when the surface was last brought up to date
        std::vector<std::byte> surface;
    };
    static Saved read(ByteStream& in);
    void restore(Scene& scene, const Saved& saved);

  private:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;
    static constexpr uint32_t kNothingWritten = 0xffffffffu;

    void updateSurface(Scene& scene, uint32_t broken);
    void placeWaiting(Scene& scene, const Projectiles& projectiles);
    void writeParticles(Scene& scene, const RenderStreams& streams);
    void writeColours(Scene& scene, const ColourStreams& colours);
    void writeFragments(Scene& scene, const RenderStreams& streams);
    void writeCracks(Scene& scene, const RenderStreams& streams);
    Fracture fracture(Scene& scene);

    FractureSurface<Backend> surface_;
    Buffer<uint8_t> broken_bonds_;
    Buffer<float> opening_;                  ///< m, of bonds
    uint32_t surface_of_ = 0;                ///< broken bonds that the surface has been told of
    uint32_t written_of_ = kNothingWritten;  ///< broken bonds when the draw lists were last written
    Buffer<Vec4<Real>> waiting_;             ///< as WriteParticles::shown
    std::vector<Vec4<Real>> waiting_on_host_;
};

template <class Backend, class Real>
void FrameExporter<Backend, Real>::write(Scene& scene, const Projectiles& projectiles, uint32_t broken,
                                         const RenderStreams& streams, bool streams_fresh) {
    updateSurface(scene, broken);
    if (streams.particles.data != nullptr || streams.projectiles.data != nullptr) {
        placeWaiting(scene, projectiles);
        writeParticles(scene, streams);
    }
    if (streams.colours.stress.data != nullptr) writeColours(scene, streams.colours);
    writeFragments(scene, streams);
    const bool draws_surface = streams.commands.data != nullptr, lists_changed = written_of_ != broken;
    if (draws_surface && (streams_fresh || lists_changed))
        surface_.write(streams, scene.fragments.drawn().clusters.fragment(),
                       scene.fragments.drawn().clusters.rows().size, streams_fresh);
    else
        surface_.tellUnchanged(streams);
    if (streams.crack_edges.data != nullptr && broken > 0) writeCracks(scene, streams);
    if (draws_surface && !streams_fresh) written_of_ = broken;  // fresh streams may be another reader's
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::writeParticles(Scene& scene, const RenderStreams& streams) {
    const uint32_t total = scene.tables.counts.total, in_bodies = scene.tables.counts.in_bodies;
    const Real speed_scale = static_cast<Real>(1 / speedOfFullColour(scene.setup));
    const auto writeFrom = [&](uint32_t first, const Stream<ParticleInstance>& stream) {
        if (stream.data == nullptr) return;
        scene.backend.forEach(
            total - first,
            WriteParticles<Real>{scene.arrays(), scene.fragments.drawn().clusters.fragment(), waiting_.view(),
                                 Span(stream.data, stream.capacity), in_bodies, first, streams.colour,
                                 speed_scale},
            "write particles");
    };
    writeFrom(0, streams.particles);
    writeFrom(in_bodies, streams.projectiles);
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::writeColours(Scene& scene, const ColourStreams& colours) {
    const auto& [damage, stress, speed] = colours;
    scene.backend.forEach(
        std::min<size_t>(scene.tables.counts.in_bodies, stress.capacity),
        WriteColours<Real>{scene.arrays(), Span(damage.data, damage.capacity),
                           Span(stress.data, stress.capacity), Span(speed.data, speed.capacity),
                           static_cast<Real>(1 / speedOfFullColour(scene.setup))},
        "write colours");
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::writeFragments(Scene& scene, const RenderStreams& streams) {
    const auto& clusters = scene.fragments.drawn().clusters;
    if (const auto& slots = streams.particle_fragment; slots.data != nullptr)
        scene.backend.forEach(std::min<size_t>(scene.tables.counts.total, slots.capacity),
                              CopyFragments{clusters.fragment(), Span(slots.data, slots.capacity)},
                              "write fragments");
    if (const auto& transforms = streams.transforms; transforms.data != nullptr)
        scene.fragments.drawn().motion.writeTransforms(clusters.rows(),
                                                       Span(transforms.data, transforms.capacity));
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::writeCracks(Scene& scene, const RenderStreams& streams) {
    const auto& bonds = scene.data.bonds;
    scene.backend.forEach(bonds.count,
                          MeasureOpenings<Real>{scene.state(), bonds.in(), bonds.slot_of_bond.view(),
                                                bonds.twin.view(), opening_.span()},
                          "measure openings");
    surface_.writeCracks(streams, scene.fragments.drawn().clusters.fragment(), opening_.view());
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::placeWaiting(Scene& scene, const Projectiles& projectiles) {
    std::vector<Vec4<Real>> waiting(kMaxProjectiles);
    for (uint32_t slot = 0; slot < projectiles.all().size(); ++slot) {
        const Double3 x = projectiles.waitingAt(slot, scene.time());
        waiting[slot] = withW(toReal<Real>(Vec3<double>{x.x, x.y, x.z}),
                              static_cast<Real>(projectiles.all()[slot].radius));
    }
    const auto same = [](const Vec4<Real>& a, const Vec4<Real>& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
    };
    if (std::equal(waiting.begin(), waiting.end(), waiting_on_host_.begin(), waiting_on_host_.end(), same))
        return;
    scene.backend.upload(waiting_.span(), waiting.data(), waiting.size());
    scene.backend.synchronize();
    waiting_on_host_ = std::move(waiting);
}

template <class Backend, class Real>
Fracture FrameExporter<Backend, Real>::fracture(Scene& scene) {
    const auto& bonds = scene.data.bonds;
    scene.backend.forEach(bonds.count,
                          MarkBrokenBonds{bonds.slot_of_bond.view(), bonds.link.view(), broken_bonds_.span()},
                          "mark broken bonds");
    const auto& clusters = scene.fragments.drawn().clusters;
    return {clusters.fragment(), clusters.rows().size, broken_bonds_.view()};
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::updateSurface(Scene& scene, uint32_t broken) {
    if (surface_of_ == broken) return;
    surface_.update(fracture(scene));
    surface_of_ = broken;
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::save(ByteStream& out) {
    out.writeValue(surface_of_);
    out.writeVector(surface_.saveState());
}

template <class Backend, class Real>
typename FrameExporter<Backend, Real>::Saved FrameExporter<Backend, Real>::read(ByteStream& in) {
    const auto broken = in.readValue<uint32_t>();
    return {broken, in.readVector<std::byte>()};
}

template <class Backend, class Real>
void FrameExporter<Backend, Real>::restore(Scene& scene, const Saved& saved) {
    // Before the first crack the surface knows of no fragments, though parts of a body may lie apart.
    if (saved.broken == 0)
        surface_.reset();
    else
        surface_.restoreState(saved.surface, fracture(scene));
    surface_of_ = saved.broken;
    written_of_ = kNothingWritten;
}

}  // namespace demolish
