// SPDX-License-Identifier: Apache-2.0
// The fragments of the scene: which particles belong to which, and how each moves as a whole.
#pragma once
#include <optional>
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

/// Particles that hang together, and how they move as a whole.
template <class Backend, class Real>
struct Clusters {
    Clustering<Backend> clusters;
    FragmentMotion<Backend, Real> motion;

    Clusters(Backend& backend, const ParticleCounts& counts, const std::vector<BodyInstance>& bodies,
             bool across)
        : clusters(backend, counts),
          motion(backend, restPositions<Real>(bodies), particlesPerBody(bodies), across) {}

    void gather(const SolverData<Backend, Real>& data) {
        motion.gather(clusters.rows(), data.particles.in(data.current), data.ownMasses());
    }
};

/// Owns the clusters and their sums; both lag behind the particles until they are told to follow. Where
/// mortar joins bodies, a fragment moves as one, but each of its bodies is drawn from its own frame.
template <class Backend, class Real>
class Fragments : public Clusters<Backend, Real> {
  public:
    using Clusters<Backend, Real>::clusters;
    using Clusters<Backend, Real>::motion;

    /// Keeps a reference to the backend. Call recluster() before anything else.
    Fragments(Backend& backend, const ParticleCounts& counts, const SceneSetup& setup)
        : Clusters<Backend, Real>(backend, counts, setup.bodies, setup.mortar.has_value()) {
        if (setup.mortar) of_bodies_.emplace(backend, counts, setup.bodies, false);
    }

    /// Pieces of single bodies, for whoever draws them.
    Clusters<Backend, Real>& drawn() { return of_bodies_ ? *of_bodies_ : *this; }

    /// Call when bonds have broken.
    void recluster(const SolverData<Backend, Real>& data) {
        const Span<const uint32_t> rows = data.bonds.row_start.view();
        clusters.update(rows, data.bonds.link.view());
        if (of_bodies_)
            of_bodies_->clusters.update(rows, data.bonds.link.view(), data.particles.owner.view());
    }
    /// A frame has passed.
    void advanceAges() {
        forEachClusters([](auto& some) { some.motion.advanceAges(some.clusters.rows()); });
    }
    /// Mass and pose of each, of the present state.
    void gather(const SolverData<Backend, Real>& data) {
        forEachClusters([&](auto& some) { some.gather(data); });
    }
    /// Calls visit(clusters): what moves as one, and what is drawn where that is another matter.
    template <class Visit>
    void forEachClusters(const Visit& visit) {
        visit(static_cast<Clusters<Backend, Real>&>(*this));
        if (of_bodies_) visit(*of_bodies_);
    }
    /// Both at once: particles were put elsewhere and bonds set otherwise.
    void follow(const SolverData<Backend, Real>& data) {
        recluster(data);
        gather(data);
    }
    /// After gather(). Waits.
    FragmentSummary summary() { return motion.summary(clusters.rows()); }

  private:
    std::optional<Clusters<Backend, Real>> of_bodies_;
};

}  // namespace demolish
