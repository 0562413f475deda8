// SPDX-License-Identifier: Apache-2.0
// Grit and dust of faces that have opened: bonds that are broken, and whose two ends have come into different
// fragments. A hairline inside a fragment throws nothing off yet.
#pragma once
#include "sim_cuda/effects/sources.h"

namespace demolish {

/// The face of a bond, in the frame of particle i at rest.
struct BondFace {
    uint32_t i = 0, j = 0;  ///< i < j, particles of the scene
    float area = 0;         ///< m^2
    float length = 0;       ///< m, from seed to seed
    Vec3<float> from_i;     ///< m, from the seed of i to the face's centroid
    Vec3<float> normal;     ///< unit, from i to j
};

/// Bonds of all bodies, in the order of the solver.
inline std::vector<BondFace> bondFaces(const std::vector<BodyInstance>& bodies) {
    std::vector<BondFace> faces;
    uint32_t first = 0;
    for (const BodyInstance& instance : bodies) {
        const BreakableBody& body = *instance.body;
        for (const BondGeometry& bond : body.bonds) {
            const Double3 &at = bond.centroid, &seed = body.particles[bond.i].seed, &n = bond.normal;
            faces.push_back({first + bond.i,
                             first + bond.j,
                             float(bond.area),
                             float(bond.length),
                             {float(at.x - seed.x), float(at.y - seed.y), float(at.z - seed.z)},
                             {float(n.x), float(n.y), float(n.z)}});
        }
        first += static_cast<uint32_t>(body.particles.size());
    }
    return faces;
}

DEM_FN bool isOpen(const BondFace& face, const BondLink& link, const Span<const uint32_t>& fragment) {
    return !isBonded(link) && fragment[face.i] != fragment[face.j];
}

/// Faces that are open already throw nothing off any more.
struct MarkOpenFaces {
    Span<const BondFace> face;
    Span<const uint32_t> slot_of_bond;
    Span<const BondLink> link;
    Span<const uint32_t> fragment;
    Span<uint8_t> opened;

    DEM_FN void operator()(uint32_t b) const {
        opened[b] = isOpen(face[b], link[slot_of_bond[b]], fragment) ? 1 : 0;
    }
};

/// How much each face throws off in this frame.
template <class Real>
struct CountOfFaces {
    BodiesNow<Real> bodies;
    Span<const BondFace> face;
    Span<const uint32_t> slot_of_bond;
    Span<const BondLink> link;
    Span<uint8_t> opened;
    Span<uint32_t> grains, puffs;  ///< per bond
    uint64_t seed = 0;

    DEM_FN void operator()(uint32_t b) const {
        grains[b] = puffs[b] = 0;
        if (opened[b] != 0 || !isOpen(face[b], link[slot_of_bond[b]], bodies.fragment)) return;
        opened[b] = 1;
        Draws draws(seed ^ 0x5bd1e995u, b);
        const DebrisLaw& law = bodies.lawOf(face[b].i);
        grains[b] = draws.whole(law.grit_per_m2 * face[b].area * (0.3f + 1.4f * draws.uniform()));
        puffs[b] = draws.whole(law.puffs_per_m2 * face[b].area);
    }
};

template <class Real>
struct ThrowOffFaces {
    BodiesNow<Real> bodies;
    Span<const BondFace> face;
    Births births;

    DEM_FN void operator()(uint32_t b) const {
        const uint32_t grains = births.grainsOf(b), puffs = births.puffsOf(b);
        if (grains + puffs == 0) return;
        const BondFace& own = face[b];
        const float apart = length(bodies.velocity(own.j) - bodies.velocity(own.i));
        const float speed = 0.5f * length(bodies.velocity(own.i) + bodies.velocity(own.j));
        for (uint32_t k = 0; k < grains; ++k) throwGrain(own, births.grainNumber(b, k), apart, speed);
        for (uint32_t k = 0; k < puffs; ++k) raisePuff(own, births.puffNumber(b, k), speed);
    }

  private:
    /// A point of the face, `offset` in its plane, as it moves with one side of it.
    DEM_FN Source sideOf(const BondFace& own, bool of_j, const Vec3<float>& offset) const {
        const uint32_t side = of_j ? own.j : own.i;
        const Vec3<float> at_rest = own.from_i + offset - (of_j ? own.length : 0.0f) * own.normal;
        const Vec3<float> arm = bodies.turned(side, at_rest);
        return {bodies.position(side) + arm, bodies.velocityAt(side, arm)};
    }
    DEM_FN Vec3<float> onFace(const BondFace& own, Draws& draws) const {
        const Vec3<float> p = draws.inBall();
        const float radius = squareRoot(own.area * (1.0f / 3.14159265f));
        return radius * (p - dot(p, own.normal) * own.normal);
    }
    /// What flies lies between the two sides, in speed as well. Fine grit is faster.
    DEM_FN void throwGrain(const BondFace& own, uint32_t number, float apart, float speed) const {
        const DebrisLaw& law = bodies.lawOf(own.i);
        Draws draws = births.grainDraws(number);
        const float size = law.spacing * sizeAt(bodies.sizes.grit, draws.uniform());
        const Vec3<float> offset = onFace(own, draws);
        Source from = sideOf(own, draws.uniform() < 0.5f, offset);
        const Source other = sideOf(own, true, offset);
        const float share = draws.uniform(), fine = 0.15f * law.spacing / size;
        const Vec3<float> before = from.velocity;
        from.velocity = axpy(share, other.velocity - before, before);
        from.violence = 1.6f * squareRoot(squareRoot(fine)) * (0.35f + 0.5f * apart + 0.12f * speed);
        births.put(number, thrown(from, size, law.drag, births.elapsed, draws));
    }
    /// Most stay on their piece for a while: they make its trail.
    DEM_FN void raisePuff(const BondFace& own, uint32_t number, float speed) const {
        Draws draws = births.puffDraws(number);
        const bool of_j = draws.uniform() < 0.5f;
        Source from = sideOf(own, of_j, onFace(own, draws));
        from.velocity = 0.5f * from.velocity;
        from.violence = 0.25f + 0.15f * speed;
        Puff puff = raised(from, bodies.lawOf(own.i), draws);
        puff.carrier = of_j ? own.j : own.i;
        if (draws.uniform() < 0.6f) puff.waits = kLongestWait * draws.uniform();
        births.put(number, puff);
    }
};

}  // namespace demolish
