// SPDX-License-Identifier: Apache-2.0
// How each fragment is moved, and the lists of those that are. A fragment's slot is its lowest particle id; a
// projectile's slot is its own.
#pragma once
#include "sim_cuda/backend/span.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/physics/rigid_motion.h"

namespace demolish {

enum class Regime : uint32_t {
    kBonded = 0,  ///< every particle by itself, with its bonds
    kRigid = 1,   ///< as one body, with contact steps
    kAsleep = 2,  ///< not at all
};
DEM_FN uint32_t wordOf(Regime regime) {
    return static_cast<uint32_t>(regime);
}

/// Which particles a substep moves. Without a list: all. Carried ones belong to rigid fragments that may
/// touch what is moved with its bonds: substeps move them along their velocity and add up what they feel, for
/// the contact step of their fragment.
struct BondedWork {
    Span<const uint32_t> ids;     ///< particles of bodies: bonded, ascending, then carried; no data: all
    Span<const uint32_t> count;   ///< two words: how many ids are bonded, how many carried
    Span<const uint32_t> bonds;   ///< CPU only: bonds with a particle among the ids
    Span<const uint32_t> regime;  ///< per slot, for the projectiles; no data: all are moved
    uint32_t at_most = 0;         ///< ids that the host knows there cannot be more of

    DEM_FN bool all() const { return ids.data == nullptr; }
    DEM_FN uint32_t listed() const { return count[0] + count[1]; }
    DEM_FN bool movesProjectile(uint32_t slot) const {
        return regime.data == nullptr || regime[slot] == wordOf(Regime::kBonded);
    }
};

/// Half substeps, more than any lag (Flight).
inline constexpr int32_t kMostLag = 64;
/// What a rigid body leaves to the one that goes on with its fragment; null: nothing.
struct BodyMemory {
    uint32_t contacts_and_flight = 0;
    uint32_t standing = 0;  ///< as in RigidBody
};
DEM_FN BodyMemory memoryOf(const RigidBody& body) {
    return {body.contacts | static_cast<uint32_t>(body.flight.lag + kMostLag) << 24 | body.flight.free << 31,
            body.standing};
}
DEM_FN uint32_t rememberedContacts(const BodyMemory& memory) {
    return memory.contacts_and_flight & 0xffffffu;
}
DEM_FN Flight rememberedFlight(const BodyMemory& memory) {
    const uint32_t word = memory.contacts_and_flight;
    return {static_cast<int32_t>(word >> 24 & 0x7fu) - kMostLag, word >> 31};
}

/// Contacts of a fragment that are as stiff as a single one of it would be, all at once: the step is stable
/// far beyond.
inline constexpr uint32_t kContactsPerShare = 4;

/// A warp moves a fragment of so many active particles or fewer, a block one of more.
inline constexpr uint32_t kShortRigidRow = 64;

/// Fragments that move as rigid bodies, and those of their particles that may touch something.
struct RigidWork {
    Span<const uint32_t> fragment;            ///< slots, ascending
    Span<const uint32_t> first, last;         ///< per entry of `fragment`: its places in `active`
    Span<const uint32_t> active;              ///< particle ids by (fragment, id)
    Span<const uint32_t> large;               ///< entries with more than kShortRigidRow places, in any order
    Span<const uint32_t> counts;              ///< kWorkWords
    Span<RigidBody> body;                     ///< per slot
    Span<BodyMemory> memory;                  ///< per slot: memoryOf() its body; 0: none yet
    Span<const Vec3<double>> arm;             ///< per particle: from the centre at the start, m
    Span<const Quat<double>> start_rotation;  ///< per particle, at the start
    Span<const uint32_t> label;               ///< per particle: its fragment's slot
    uint32_t active_at_most = 0, fragments_at_most = 0, large_at_most = 0;
};

/// Constants of all particles in contact steps, and in substeps where rigid fragments move too.
template <class Real>
struct RigidConstants {
    Span<ParticleConstants<Real>> in_contact_steps, in_substeps;
};

inline constexpr uint32_t kActiveCount = 0, kFragmentCount = 1, kBondedCount = 2, kCarriedCount = 3,
                          kAsleepCount = 4, kAwakeBodies = 5, kAwakeCount = 6, kMustBondCount = 7,
                          kLargeCount = 8, kHitsLater = 9, kBondedShots = 10, kWorkWords = 11;

}  // namespace demolish
