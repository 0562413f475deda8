// SPDX-License-Identifier: Apache-2.0
// First stage of a list build: where every particle is and goes now, how far it reaches, whether anything can
// reach it, and the box of all velocities.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/fill_grid.h"
#include "sim_cuda/kernels/velocity_range.h"

namespace demolish {

/// Gives the range of the particle's own velocity; empty for a slot that takes part in nothing.
template <class Real>
struct StartPaths {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Span<const uint32_t> bond_row;
    Span<const BondLink> link;
    Span<const uint32_t> buried;  ///< per particle of a body: 1 while its bonds hold
    Span<Vec4<Real>> built_position, built_velocity;
    Span<uint32_t> place_kind;  ///< per particle of a body: kInGrid or kEnclosed
    Real skin_share{};          ///< skin of a body's particle over its R_c
    Real largest_skin{};        ///< m, no skin is wider (projectiles)
    uint32_t in_bodies = 0;

    DEM_FN VelocityRanges<Real> operator()(uint32_t i) const {
        const ParticleConstants<Real> own = constants[i];
        const Real skin = minOf(skin_share * own.contact_radius, largest_skin);
        const Vec3<Real> velocity = xyz(state.velocity[i]);
        const bool active = own.takesPart();
        built_position[i] = withW(positionOf(state, i), own.contact_radius + skin);
        built_velocity[i] = withW(velocity, active ? skin : Real(kNoPath));
        VelocityRanges<Real> ranges;
        if (i < in_bodies)
            place_kind[i] = standsBetweenBonds(buried, bond_row, link, i) ? kEnclosed : kInGrid;
        if (!active) return ranges;
        VelocityRange<Real>& range = i < in_bodies ? ranges.bodies : ranges.projectiles;
        range.low = range.high = velocity;
        return ranges;
    }
};

}  // namespace demolish
