// SPDX-License-Identifier: Apache-2.0
// Where everybody is seen from the paths on which the contact lists rely, and who has left them.
#pragma once
#include <bit>

#include "sim_cuda/data/bonds.h"
#include "sim_cuda/kernels/predicted_path.h"

namespace demolish {

/// The sooner, the larger the word: threads agree by the largest, and 0 means never. `seconds` >= 0.
DEM_FN uint32_t soonest(float seconds) {
    return ~std::bit_cast<uint32_t>(seconds);
}
/// Raises a word that may be told from many threads.
DEM_FN void tellSoonest(uint32_t& word, float seconds) {
    const uint32_t told = soonest(seconds);
    if (told > atomicLoadU32(&word)) atomicMaxU32(&word, told);
}
/// s; infinite for never.
inline double secondsOf(uint32_t word) {
    return word == 0 ? 1e30 : static_cast<double>(std::bit_cast<float>(~word));
}

/// As in PathsIn, but the position is that of this moment.
template <class Real>
struct PathFromHere {
    Vec4<Real> position, velocity;
};

/// Paths at a moment, `elapsed` s after the build.
template <class Real>
struct PathsNow {
    StateIn<Real> state;
    PathsIn<Real> paths;
    Real elapsed{}, lookahead{};
    Enclosures enclosures{};

    DEM_FN bool strays(uint32_t i) const {
        return leavesPath(paths.position[i], paths.velocity[i], positionOf(state, i), xyz(state.velocity[i]),
                          elapsed, lookahead);
    }
    DEM_FN PathFromHere<Real> former(uint32_t i) const {
        const Vec4<Real> start = paths.position[i], velocity = paths.velocity[i];
        return {withW(axpy(elapsed, xyz(velocity), xyz(start)), reachOf(start)), velocity};
    }
    DEM_FN PathFromHere<Real> anew(uint32_t i) const {
        return {withW(positionOf(state, i), reachOf(paths.position[i])),
                withW(xyz(state.velocity[i]), skinOf(paths.velocity[i]))};
    }
    DEM_FN PathFromHere<Real> now(uint32_t i) const { return strays(i) ? anew(i) : former(i); }
};

/// One thread a particle: raises the flag when the lists have to be built again; a state that is not finite
/// raises it too.
template <class Real>
struct CheckPaths {
    PathsNow<Real> paths;
    Span<uint32_t> flag;  ///< one word

    DEM_FN void operator()(uint32_t i) const {
        if (paths.strays(i)) atomicOrU32(&flag[0], 1u);
    }
};

}  // namespace demolish
