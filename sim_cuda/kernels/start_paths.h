// SPDX-License-Identifier: Apache-2.0
// First stage of a list build: where every particle is and goes now, how far it reaches, whether anything can
// reach it, and the box of all velocities.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/fill_grid.h"
#include "sim_cuda/kernels/predicted_path.h"
#include "sim_cuda/kernels/velocity_range.h"

namespace demolish {

/// One thread a particle of a body, before StartPaths, which asks for all that a particle is bonded to.
struct MarkUncracked {
    Enclosures enclosures;
    Span<uint8_t> uncracked;  ///< per particle of a body: 1 while all its bonds hold

    DEM_FN void operator()(uint32_t i) const { uncracked[i] = enclosures.allBondsHold(i) ? 1 : 0; }
};

/// Gives the range of the particle's own velocity; empty for a slot that takes part in nothing.
template <class Real>
struct StartPaths {
    StateIn<Real> state;
    Span<const ParticleConstants<Real>> constants;
    Enclosures enclosures;
    Span<const uint8_t> uncracked;  ///< by MarkUncracked
    Span<Vec4<Real>> built_position, built_velocity;
    Span<uint32_t> place_kind;  ///< per particle of a body: kInGrid or kEnclosed
    Real skin_share{};          ///< skin of a body's particle over its R_c
    Real largest_skin{};        ///< m, no skin is wider (projectiles)
    Real blind_time{};          ///< s, from a hit until the lists know of it
    Real longest_horizon{};     ///< s, that the lists may hold

    DEM_FN VelocityRanges<Real> operator()(uint32_t i) const {
        const Vec4<Real> position = pathPosition(i), velocity = pathVelocity(i);
        const uint32_t in_bodies = enclosures.in_bodies;
        built_position[i] = position;
        built_velocity[i] = velocity;
        VelocityRanges<Real> ranges;
        if (i < in_bodies) {
            const bool enclosed = enclosures.holdDeeply(i, uncracked) && !meetsProjectile(position, velocity);
            place_kind[i] = enclosed ? kEnclosed : kInGrid;
        }
        if (!hasPath(velocity)) return ranges;
        VelocityRange<Real>& range = i < in_bodies ? ranges.bodies : ranges.projectiles;
        range.low = range.high = xyz(velocity);
        return ranges;
    }

  private:
    DEM_FN Real skin(uint32_t i) const {
        return minOf(skin_share * constants[i].contact_radius, largest_skin);
    }
    /// A projectile throws what it hits off its path as fast as it flies itself: it is listed with whatever
    /// may come into its way before the lists know.
    DEM_FN Real thrown(uint32_t i) const {
        if (i < enclosures.in_bodies) return Real(0);
        const Vec3<Real> velocity = xyz(state.velocity[i]);
        return blind_time * squareRoot(length2(velocity));
    }
    DEM_FN Vec4<Real> pathPosition(uint32_t i) const {
        return withW(positionOf(state, i), constants[i].contact_radius + skin(i) + thrown(i));
    }
    DEM_FN Vec4<Real> pathVelocity(uint32_t i) const {
        return withW(xyz(state.velocity[i]), constants[i].takesPart() ? skin(i) : Real(kNoPath));
    }
    DEM_FN bool meetsProjectile(const Vec4<Real>& position, const Vec4<Real>& velocity) const {
        for (uint32_t p = enclosures.in_bodies; p < constants.size(); ++p)
            if (constants[p].takesPart() &&
                mayMeet(position, velocity, pathPosition(p), pathVelocity(p), longest_horizon))
                return true;
        return false;
    }
};

}  // namespace demolish
