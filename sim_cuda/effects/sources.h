// SPDX-License-Identifier: Apache-2.0
// Where grains and puffs come from: what kernels see of the bodies, only to read, and how one is thrown off.
#pragma once
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/effects/debris_law.h"
#include "sim_cuda/effects/rings.h"

namespace demolish {

/// The bodies at the end of the frame.
template <class Real>
struct BodiesNow {
    StateIn<Real> state;
    Span<const uint32_t> fragment;  ///< slot of each particle
    Span<const uint32_t> owner;     ///< body of each particle
    Span<const DebrisLaw> law;      ///< per body
    SizeTables sizes;

    DEM_FN const DebrisLaw& lawOf(uint32_t i) const { return law[owner[i]]; }
    DEM_FN Vec3<float> position(uint32_t i) const { return single(positionOf(state, i)); }
    DEM_FN Vec3<float> velocity(uint32_t i) const { return single(xyz(state.velocity[i])); }
    /// From the particle's own frame.
    DEM_FN Vec3<float> turned(uint32_t i, const Vec3<float>& v) const {
        return single(rotate(asQuat(state.rotation[i]), Vec3<Real>{Real(v.x), Real(v.y), Real(v.z)}));
    }
    /// Of what moves with particle i and stands `arm` away from it.
    DEM_FN Vec3<float> velocityAt(uint32_t i, const Vec3<float>& arm) const {
        return velocity(i) + cross(single(xyz(state.spin[i])), arm);
    }

  private:
    DEM_FN static Vec3<float> single(const Vec3<Real>& v) { return {float(v.x), float(v.y), float(v.z)}; }
};

/// A place that throws off grains.
struct Source {
    Vec3<float> position, velocity;  ///< m, m/s, at the end of the frame
    float violence = 0;              ///< m/s, of what is thrown off
};

/// It has left at some moment of the frame, and has flown since.
DEM_FN Grain thrown(const Source& source, float size, float drag, float elapsed, Draws& draws) {
    Grain grain;
    const float share = draws.uniform();
    grain.size = size;
    grain.velocity = source.velocity + (source.violence * share * squareRoot(share)) * draws.direction();
    grain.position = axpy(elapsed * draws.uniform(), grain.velocity - source.velocity, source.position);
    grain.rotation = draws.orientation();
    const float turning = 20.0f + 60.0f * draws.uniform();  // drawn first, whatever a compiler would do
    grain.spin = turning * draws.direction();
    grain.seed = draws.word();
    grain.drag = drag;
    return grain;
}

/// `carrier` with waits > 0: it stays on that particle for so long.
DEM_FN Puff raised(const Source& source, const DebrisLaw& law, Draws& draws) {
    Puff puff;
    puff.position = source.position;
    puff.velocity = source.velocity + source.violence * draws.inBall();
    puff.first_radius = static_cast<float>(kPuffRadius) * law.spacing * (0.6f + 0.8f * draws.uniform());
    puff.first_depth = law.puff_depth * (0.5f + draws.uniform());
    puff.life = kPuffLife * (0.5f + draws.uniform());
    const float share = draws.uniform();
    puff.slowing = 0.06f + 0.2f * share * share;
    puff.seed = draws.word();
    return puff;
}

}  // namespace demolish
