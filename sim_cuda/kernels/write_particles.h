// One sphere a particle and projectile, for the particle view, coloured by what the viewer asked for.
#pragma once
#include "sim_cuda/api/render_streams.h"
#include "sim_cuda/kernels/own_particle.h"

namespace demolish {

/// (E2) over strength of a particle's worst solid bond, 0..1; what a stress colour shows. Of the bonds to
/// particles from `least` on: it is the same at both ends.
template <class Real>
DEM_FN Real worstStressRatio(const SubstepArrays<Real>& arrays, const OwnParticle<Real>& own,
                             uint32_t least = 0) {
    Real worst = Real(0);
    for (uint32_t s = arrays.bond_row[own.id]; s < arrays.bond_row[own.id + 1]; ++s) {
        const BondLink link = arrays.link[s];
        if (!isBonded(link) || linkedParticle(link) < least) continue;
        const BondConstants<Real> bond =
            bondConstants(arrays.rest[s], link.grade, arrays.body_laws[own.owner]);
        const PairMotion<Real> pair = pairMotion(own.state, loadState(arrays.in, linkedParticle(link)));
        const BondEffect<Real> effect = bondEffect(bond, pair);
        worst = maxOf(worst, effect.severity / effect.limit);
    }
    return worst;
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
            if (!(own.constants.inverse_mass > Real(0))) position = xyz(waiting);
            radius = waiting.w;
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
        if (colour == ParticleColour::kDamage) return damage(own.id);
        if (colour == ParticleColour::kStress) return minOf(worstStressRatio(arrays, own), Real(1));
        if (colour == ParticleColour::kSpeed)
            return minOf(speed_scale * length(xyz(own.state.velocity)), Real(1));
        return static_cast<Real>((slot * 2654435761u) >> 8) * Real(1.0 / 16777216);
    }

    /// Share of its bonds that are broken.
    DEM_FN Real damage(uint32_t i) const {
        const uint32_t first = arrays.bond_row[i], last = arrays.bond_row[i + 1];
        if (first == last) return Real(0);
        uint32_t broken = 0;
        for (uint32_t s = first; s < last; ++s) broken += isBonded(arrays.link[s]) ? 0u : 1u;
        return static_cast<Real>(broken) / static_cast<Real>(last - first);
    }
};

}  // namespace demolish
