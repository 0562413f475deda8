// SPDX-License-Identifier: Apache-2.0
// The state hash: a sum of one well-mixed number for each particle, bond record and contact, so that no order
// matters.
#pragma once
#include <bit>

#include "sim_cuda/backend/atomics.h"
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/contact_rows.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/physics/random.h"

namespace demolish {

DEM_FN uint64_t bitsOf(float value) {
    return std::bit_cast<uint32_t>(value);
}
DEM_FN uint64_t bitsOf(double value) {
    return std::bit_cast<uint64_t>(value);
}

/// Chains four numbers onto a hash.
template <class Real>
DEM_FN uint64_t mixIn(uint64_t hash, const Vec4<Real>& a) {
    hash = counterHash(hash, bitsOf(a.x));
    hash = counterHash(hash, bitsOf(a.y));
    hash = counterHash(hash, bitsOf(a.z));
    return counterHash(hash, bitsOf(a.w));
}

/// Which kind of thing an entry is.
enum class HashedKind : uint64_t { kParticle = 1, kBond = 2, kContact = 3, kCollider = 4 };

DEM_FN uint64_t entryHash(HashedKind kind, uint64_t a, uint64_t b) {
    return counterHash(counterHash(static_cast<uint64_t>(kind), a), b);
}
template <class Real>
DEM_FN bool isNull(const Vec4<Real>& spring) {
    return !(spring.x != Real(0)) && !(spring.y != Real(0)) && !(spring.z != Real(0));
}

/// Particle i: its state, its bond records, its contacts and its springs against colliders. Springs at rest
/// do not count, so that it does not matter which pairs happen to be listed.
template <class Real>
struct HashParticle {
    StateIn<Real> state;
    BondRowsIn<Real> bonds;
    ContactRowsIn<Real> contacts;
    Span<const Vec4<Real>> collider_spring;
    uint32_t colliders = 0, total = 0;
    Span<uint64_t> sum;

    DEM_FN void operator()(uint32_t i) const {
        uint64_t hash = entryHash(HashedKind::kParticle, i, 0);
        hash = mixIn(mixIn(hash, state.position[i]), state.rotation[i]);
        hash = mixIn(mixIn(hash, state.velocity[i]), state.spin[i]);
        for (uint32_t s = bonds.row_start[i]; s < bonds.row_start[i + 1]; ++s)
            hash += mixIn(entryHash(HashedKind::kBond, i, bonds.link[s].link), bonds.spring[s]);
        for (uint32_t s = contacts.row_start[i]; s < contacts.row_start[i + 1]; ++s)
            if (!isNull(contacts.spring[s]))
                hash += mixIn(entryHash(HashedKind::kContact, i, contacts.neighbour[s]), contacts.spring[s]);
        for (uint32_t c = 0; c < colliders; ++c)
            if (!isNull(collider_spring[c * total + i]))
                hash += mixIn(entryHash(HashedKind::kCollider, i, c), collider_spring[c * total + i]);
        atomicAddU64(&sum[0], hash);
    }
};

}  // namespace demolish
