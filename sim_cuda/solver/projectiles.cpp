// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/projectiles.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sim_cuda/api/errors.h"
#include "sim_cuda/physics/scalar.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

double projectileMass(const Projectile& p) {
    return p.density * 4.0 / 3 * kPi * p.radius * p.radius * p.radius;
}

Projectiles::Projectiles(std::vector<Projectile> waiting, const Double3& gravity, double time_step)
    : all_(std::move(waiting)), gravity_(gravity), time_step_(time_step) {}

void Projectiles::fire(const Projectile& projectile, uint64_t substep) {
    checkProjectile(projectile);
    if (all_.size() >= kMaxProjectiles)
        throw UsageError("A run has at most " + std::to_string(kMaxProjectiles) +
                         " projectiles; reset the scene.");
    all_.push_back(projectile);
    all_.back().start_time = static_cast<double>(substep) * time_step_;
}

uint64_t Projectiles::startSubstep(const Projectile& projectile) const {
    return static_cast<uint64_t>(std::ceil(projectile.start_time / time_step_ - 1e-6));
}

uint64_t Projectiles::nextStart() const {
    uint64_t next = ~uint64_t{0};
    for (size_t slot = 0; slot < all_.size(); ++slot)
        if (!hasStarted(slot)) next = std::min(next, startSubstep(all_[slot]));
    return next;
}

std::vector<uint32_t> Projectiles::due(uint64_t substep) const {
    std::vector<uint32_t> slots;
    for (uint32_t slot = 0; slot < all_.size(); ++slot)
        if (!hasStarted(slot) && startSubstep(all_[slot]) <= substep) slots.push_back(slot);
    return slots;
}

void Projectiles::start(uint32_t slot, const Projectile& placed) {
    all_[slot] = placed;
    state_.started |= uint64_t{1} << slot;
    if (state_.begun != 0) state_.work += energyOf(placed);
}

double Projectiles::energyOf(const Projectile& projectile) const {
    const Double3 g = gravity_, v = projectile.velocity, x = projectile.position;
    return projectileMass(projectile) *
           (0.5 * (v.x * v.x + v.y * v.y + v.z * v.z) - (g.x * x.x + g.y * x.y + g.z * x.z));
}

Double3 Projectiles::waitingAt(uint32_t slot, double time) const {
    const Projectile& shot = all_[slot];
    const double ahead = std::max(0.0, shot.start_time - time);
    return {shot.position.x - ahead * shot.velocity.x, shot.position.y - ahead * shot.velocity.y,
            shot.position.z - ahead * shot.velocity.z};
}

void Projectiles::resume(std::vector<Projectile> all, const State& state) {
    all_ = std::move(all);
    state_ = state;
}

}  // namespace demolish
