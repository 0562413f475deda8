// SPDX-License-Identifier: Apache-2.0
// Projectiles: slots after the bodies' particles, inactive until their start. Part of device_solver.h.
#pragma once
#include <algorithm>
#include <cmath>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/solver/device_solver.h"

namespace demolish {

inline double projectileMass(const Projectile& p) {
    return p.density * 4.0 / 3 * kPi * p.radius * p.radius * p.radius;
}

/// First substep at which a projectile takes part.
inline uint64_t startSubstep(const Projectile& p, double time_step) {
    return static_cast<uint64_t>(std::ceil(p.start_time / time_step - 1e-6));
}

/// Substep at which the next waiting projectile starts; the largest number when none waits.
template <class Backend, class Real>
uint64_t DeviceSolver<Backend, Real>::nextStart() const {
    uint64_t next = ~uint64_t{0};
    for (uint32_t p = 0; p < projectiles_.size(); ++p)
        if ((progress_.started >> p & 1u) == 0)
            next = std::min(next, startSubstep(projectiles_[p], tables_.time_step));
    return next;
}

/// at_most, or less: up to the next start of a waiting projectile. Those that are due have started.
template <class Backend, class Real>
uint32_t DeviceSolver<Backend, Real>::substepsUntilNextStart(uint32_t at_most) const {
    return static_cast<uint32_t>(std::min<uint64_t>(at_most, nextStart() - progress_.substeps));
}

/// Those whose time has come; energy that comes in after the beginning is external work.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::startProjectiles() {
    const Double3 g = setup_.params.gravity;
    for (uint32_t p = 0; p < projectiles_.size(); ++p) {
        const Projectile& shot = projectiles_[p];
        if ((progress_.started >> p & 1u) != 0 || startSubstep(shot, tables_.time_step) > progress_.substeps)
            continue;
        placeProjectile(p);
        progress_.started |= 1u << p;
        progress_.rebuild = 1;
        progress_.shot_started = 1;
        if (progress_.substeps == 0) continue;
        const Double3 v = shot.velocity, x = shot.position;
        progress_.energy.external += projectileMass(shot) * (0.5 * (v.x * v.x + v.y * v.y + v.z * v.z) -
                                                             (g.x * x.x + g.y * x.y + g.z * x.z));
    }
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::placeProjectile(uint32_t slot) {
    const Projectile& shot = projectiles_[slot];
    const Double3 x = shot.position, v = shot.velocity;
    const LoadedState<Real> state = packState<Real>({x.x, x.y, x.z}, {}, {v.x, v.y, v.z}, {});
    const double mass = projectileMass(shot), inertia = 0.4 * mass * shot.radius * shot.radius;
    const Vec4<Real> constants{static_cast<Real>(1 / mass), static_cast<Real>(1 / inertia),
                               static_cast<Real>(shot.radius), static_cast<Real>(shot.radius)};
    auto& particles = data_.particles;
    const uint32_t i = tables_.counts.in_bodies + slot, now = data_.current;
    backend_.upload(particles.position[now].span().part(i, 1), &state.position, 1);
    backend_.upload(particles.rotation[now].span().part(i, 1), &state.rotation, 1);
    backend_.upload(particles.velocity[now].span().part(i, 1), &state.velocity, 1);
    backend_.upload(particles.spin[now].span().part(i, 1), &state.spin, 1);
    backend_.upload(particles.constants.span().part(i, 1), &constants, 1);
    backend_.synchronize();
}

template <class Backend, class Real>
void DeviceSolver<Backend, Real>::fire(const Projectile& projectile) {
    checkProjectile(projectile);
    if (projectiles_.size() >= kMaxProjectiles)
        throw UsageError("A run has at most " + std::to_string(kMaxProjectiles) +
                         " projectiles; reset the scene.");
    projectiles_.push_back(projectile);
    projectiles_.back().start_time = static_cast<double>(progress_.substeps) * tables_.time_step;
    progress_.projectiles = static_cast<uint32_t>(projectiles_.size());
    data_.uploadLaws(backend_, buildLawTables(setup_, tables_, projectiles_));
    startProjectiles();
}

/// A waiting projectile is drawn on its way to where it starts.
template <class Backend, class Real>
void DeviceSolver<Backend, Real>::showProjectiles() {
    std::vector<Vec4<Real>> shown(kMaxProjectiles);
    const double now = static_cast<double>(progress_.substeps) * tables_.time_step;
    for (uint32_t p = 0; p < projectiles_.size(); ++p) {
        const Projectile& shot = projectiles_[p];
        const double ahead = std::max(0.0, shot.start_time - now);
        const Vec3<double> x{shot.position.x - ahead * shot.velocity.x,
                             shot.position.y - ahead * shot.velocity.y,
                             shot.position.z - ahead * shot.velocity.z};
        shown[p] = withW(toReal<Real>(x), static_cast<Real>(shot.radius));
    }
    const auto same = [](const Vec4<Real>& a, const Vec4<Real>& b) {
        return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
    };
    if (std::equal(shown.begin(), shown.end(), shown_.begin(), shown_.end(), same)) return;
    backend_.upload(shown_projectiles_.span(), shown.data(), shown.size());
    backend_.synchronize();
    shown_ = std::move(shown);
}

}  // namespace demolish
