// SPDX-License-Identifier: Apache-2.0
// One sphere a particle and projectile, for the particle view, coloured by what the viewer asked for.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/kernels/particle_value.h"

namespace demolish {

/// m, of a projectile as it is shown.
template <class Real>
DEM_FN Real shownRadius(const Vec4<Real>& shown) {
    return shown.w;
}

template <class Real>
struct WriteParticles {
    SubstepArrays<Real> arrays;     ///< only read
    Span<const uint32_t> fragment;  ///< slot of each particle's fragment
    Span<const Vec4<Real>>
        shown;  ///< per projectile slot: (where to draw it while it waits, m; radius to draw, m)
    Span<ParticleInstance> instances;
    uint32_t in_bodies = 0;
    uint32_t first_id = 0;  ///< particle that goes to the beginning of `instances`
    ParticleColour colour = ParticleColour::kFragment;
    Real speed_scale{};  ///< 1/(m/s): colour 1 at this speed

    DEM_FN void operator()(uint32_t k) const {
        const uint32_t i = first_id + k;
        if (k >= instances.size()) return;
        const OwnParticle<Real> own = loadOwn(arrays, i);
        const bool projectile = i >= in_bodies;
        Vec3<Real> position = positionOf(arrays.in, i);
        Real radius = own.constants.contact_radius;
        if (projectile) {
            const Vec4<Real> waiting = shown[i - in_bodies];
            if (!own.constants.takesPart()) position = xyz(waiting);
            radius = shownRadius(waiting);
        }
        ParticleInstance instance{};
        instance.position = {static_cast<float>(position.x), static_cast<float>(position.y),
                             static_cast<float>(position.z)};
        instance.radius = static_cast<float>(radius);
        instance.fragment = projectile ? i : fragment[i];
        instance.value = projectile ? 0.0f : static_cast<float>(value(own, instance.fragment));
        instances[k] = instance;
    }

    DEM_FN Real value(const OwnParticle<Real>& own, uint32_t slot) const {
        if (colour == ParticleColour::kDamage) return damageValue(arrays, own.id);
        if (colour == ParticleColour::kStress) return stressValue(arrays, own);
        if (colour == ParticleColour::kSpeed) return speedValue(own, speed_scale);
        return static_cast<Real>((slot * 2654435761u) >> 8) * Real(1.0 / 16777216);
    }
};

}  // namespace demolish
