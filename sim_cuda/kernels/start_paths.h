// First stage of a list build: where every particle is and goes now, and how far it reaches.
#pragma once
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"

namespace demolish {

template <class Real>
struct StartPaths {
    StateIn<Real> state;
    Span<const Vec4<Real>> constants;
    Span<Vec4<Real>> built_position, built_velocity;
    Real skin_share{};    ///< skin of a body's particle over its R_c
    Real largest_skin{};  ///< m, no skin is wider (projectiles)

    DEM_FN void operator()(uint32_t i) const {
        const ParticleConstants<Real> own = asConstants(constants[i]);
        const Real skin = minOf(skin_share * own.contact_radius, largest_skin);
        built_position[i] = withW(positionOf(state, i), own.contact_radius + skin);
        built_velocity[i] = withW(xyz(state.velocity[i]), own.inverse_mass > Real(0) ? skin : Real(-1));
    }
};

}  // namespace demolish
