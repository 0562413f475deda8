// SPDX-License-Identifier: Apache-2.0
// A look at the state every few substeps: is all of it finite and inside the scene, and do the contact lists
// still hold?
#pragma once
#include "sim_cuda/data/colliders.h"
#include "sim_cuda/kernels/paths_now.h"

namespace demolish {

/// Words that a look leaves behind.
inline constexpr uint32_t kLookRebuild = 0, kLookStatus = 1, kLookWords = 2;
inline constexpr uint32_t kSawNotFinite = 1u, kSawLeftScene = 2u;  // the bits of StepStatus

template <class Real>
struct LookAtState {
    CheckPaths<Real> paths;
    Span<const ParticleConstants<Real>> constants;
    Span<uint32_t> words;  ///< kLookWords, 0 before
    Real scene_radius{};   ///< m

    DEM_FN void operator()(uint32_t i) const {
        if (!(constants[i].takesPart())) return;
        const StateIn<Real>& state = paths.paths.state;
        const Vec3<Real> position = positionOf(state, i);
        const Vec3<Real> velocity = xyz(state.velocity[i]), spin = xyz(state.spin[i]);
        const Vec4<Real> turned = state.rotation[i];
        const Real motion = length2(velocity) + length2(spin) + (length2(xyz(turned)) + turned.w * turned.w),
                   distance2 = length2(position);
        if (!(motion + distance2 <= Real(1e30)))
            atomicOrU32(&words[kLookStatus], kSawNotFinite);
        else if (distance2 > scene_radius * scene_radius)
            atomicOrU32(&words[kLookStatus], kSawLeftScene);
        paths(i);
    }
};

}  // namespace demolish
