// SPDX-License-Identifier: Apache-2.0
// Fragments, and one frame written for drawing. Part of device_solver.h.
#pragma once
#include <algorithm>

#include "sim_cuda/api/particle_colour.h"
#include "sim_cuda/kernels/write_colours.h"
#include "sim_cuda/kernels/write_particles.h"
#include "sim_cuda/solver/device_solver.h"

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

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::sumFragments() {
    motion_.gather(clusters_.rows(), data_.particles.in(data_.current), data_.particles.constants.view());
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::countFragments() {
    const FragmentSummary summary = motion_.summary(clusters_.rows());
    stats_.fragments = summary.fragments;
    stats_.largest_fragment_fraction = summary.largest_mass / tables_.mass_in_bodies;
}

template <class Backend, class Real>
Span<const uint8_t> DeviceSolver<Backend, Real>::brokenBonds() {
    backend_.forEach(
        data_.bonds.count,
        MarkBrokenBonds{data_.bonds.slot_of_bond.view(), data_.bonds.link.view(), broken_bonds_.span()},
        "mark broken bonds");
    return broken_bonds_.view();
}

/// Bonds never heal, so that their number says whether anything has changed.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::updateSurface() {
    if (surface_of_ == progress_.broken) return;
    surface_.update(clusters_.fragment(), brokenBonds());
    surface_of_ = progress_.broken;
}

/// `broken`: how many bonds were broken when the state was taken; clusters are brought up to date first.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::restoreSurface(uint32_t broken, const std::vector<std::byte>& state) {
    clusters_.update(data_.bonds.row_start.view(), data_.bonds.link.view());
    surface_.restoreState(state, clusters_.fragment(), brokenBonds());
    surface_of_ = broken;
    written_of_ = kNothingWritten;
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::exportFrame(const RenderStreams& streams, bool streams_fresh) {
    const FragmentRows rows = clusters_.rows();
    const uint32_t total = tables_.counts.total, in_bodies = tables_.counts.in_bodies;
    updateSurface();
    if (streams.particles.data != nullptr || streams.projectiles.data != nullptr) showProjectiles();
    const Real speed_scale = static_cast<Real>(1 / speedOfFullColour(setup_));
    const auto writeParticles = [&](const Stream<ParticleInstance>& stream, uint32_t first) {
        if (stream.data == nullptr) return;
        backend_.forEach(total - first,
                         WriteParticles<Real>{data_.arrays(lists_.contacts()), clusters_.fragment(),
                                              shown_projectiles_.view(), Span(stream.data, stream.capacity),
                                              in_bodies, first, streams.colour, speed_scale},
                         "write particles");
    };
    writeParticles(streams.particles, 0);
    writeParticles(streams.projectiles, in_bodies);
    if (const auto& [damage, stress, speed] = streams.colours; stress.data != nullptr)
        backend_.forEach(
            std::min<size_t>(in_bodies, stress.capacity),
            WriteColours<Real>{data_.arrays(lists_.contacts()), Span(damage.data, damage.capacity),
                               Span(stress.data, stress.capacity), Span(speed.data, speed.capacity),
                               speed_scale},
            "write colours");
    if (streams.particle_fragment.data != nullptr) {
        const Span<uint32_t> slots(streams.particle_fragment.data, streams.particle_fragment.capacity);
        backend_.forEach(std::min<size_t>(total, slots.size()), CopyFragments{clusters_.fragment(), slots},
                         "write fragments");
    }
    if (streams.transforms.data != nullptr)
        motion_.writeTransforms(rows, Span(streams.transforms.data, streams.transforms.capacity));
    const bool draws_surface = streams.commands.data != nullptr;
    if (draws_surface && (streams_fresh || written_of_ != progress_.broken)) {
        surface_.write(streams, clusters_.fragment());
        written_of_ = progress_.broken;
    }
    backend_.synchronize();
}

}  // namespace demolish
