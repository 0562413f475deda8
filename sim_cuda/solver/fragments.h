// SPDX-License-Identifier: Apache-2.0
// The fragments of the scene: which particles belong to which, and how each moves as a whole.
#pragma once
#include <vector>

#include "sim_cuda/solver/clustering.h"
#include "sim_cuda/solver/fragment_motion.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// m, body frame, in the solver's order.
template <class Real>
std::vector<Vec4<Real>> restPositions(const std::vector<BodyInstance>& bodies) {
    std::vector<Vec4<Real>> rest;
    for (const BodyInstance& instance : bodies)
        for (const Particle& p : instance.body->particles)
            rest.push_back(withW(toReal<Real>({p.seed.x, p.seed.y, p.seed.z}), Real(0)));
    return rest;
}
inline std::vector<uint32_t> particlesPerBody(const std::vector<BodyInstance>& bodies) {
    std::vector<uint32_t> counts;
    for (const BodyInstance& instance : bodies)
        counts.push_back(static_cast<uint32_t>(instance.body->particles.size()));
    return counts;
}

/// Owns the clusters and their sums; both lag behind the particles until they are told to follow.
template <class Backend, class Real>
struct Fragments {
    Clustering<Backend> clusters;
    FragmentMotion<Backend, Real> motion;

    /// Keeps a reference to the backend. Call recluster() before anything else.
    Fragments(Backend& backend, const ParticleCounts& counts, const std::vector<BodyInstance>& bodies)
        : clusters(backend, counts), motion(backend, restPositions<Real>(bodies), particlesPerBody(bodies)) {}

    /// Call when bonds have broken.
    void recluster(const SolverData<Backend, Real>& data) {
        clusters.update(data.bonds.row_start.view(), data.bonds.link.view());
    }
    /// A frame has passed.
    void advanceAges() { motion.advanceAges(clusters.rows()); }
    /// Mass and pose of each, of the present state.
    void gather(const SolverData<Backend, Real>& data) {
        motion.gather(clusters.rows(), data.particles.in(data.current), data.ownMasses());
    }
    /// Both at once: particles were put elsewhere and bonds set otherwise.
    void follow(const SolverData<Backend, Real>& data) {
        recluster(data);
        gather(data);
    }
    /// After gather(). Waits.
    FragmentSummary summary() { return motion.summary(clusters.rows()); }
};

}  // namespace demolish
