// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/list_schedule.h"

#include <algorithm>

#include "sim_cuda/physics/rigid_motion.h"
#include "sim_cuda/solver/look_interval.h"

namespace demolish {
namespace {

/// Lists are made for so many times the time that they have lasted of late: a longer horizon than is used
/// costs a coarser grid and longer rows. Substeps that they shall last at least: two stretches.
constexpr double kHorizonLives = 2;
constexpr uint32_t kLeastHorizon = 2 * kRigidStretch.length();
/// Contact steps from a hit, right after a look, until the lists know of it, in the longest stretch.
constexpr uint32_t kBlindSteps =
    std::max({kBondedStretch.blind(), kShortBondedStretch.blind(), kRigidStretch.blind()}) / kRigidStride;

}  // namespace

NeighbourSettings ListSchedule::next(bool something_is_rigid, bool projectile_started,
                                     uint32_t longest_step) {
    NeighbourSettings settings = something_is_rigid ? kRigidNeighbours : NeighbourSettings{};
    if (!projectile_started) state_.life = std::max(state_.age, state_.life / 2);
    const double wanted = kHorizonLives * std::max(state_.life, kLeastHorizon) * time_step_;
    settings.longest_horizon = std::min(settings.longest_horizon, wanted);
    settings.blind_time = kBlindSteps * longest_step * time_step_;
    return settings;
}

void ListSchedule::built() {
    state_.age = 0;
    state_.due = 0;
}

bool ListSchedule::judge(bool left_paths, bool state_is_good, uint32_t next, double horizon) {
    const double needed = (state_.age + static_cast<double>(next)) * time_step_;
    const bool lasts = needed <= horizon, can_be_kept = left_paths && state_is_good && lasts;
    if ((left_paths && !can_be_kept) || !lasts) demand();
    return can_be_kept;
}

double ListSchedule::remaining(double horizon, uint32_t at_most) const {
    return std::clamp(horizon - age(), 0.0, at_most * time_step_);
}

uint32_t ListSchedule::lastFor(double horizon, uint32_t stretch, uint32_t at_most) const {
    constexpr double kRounding = 1e-6;  // substeps
    if (!(stretch * time_step_ > horizon)) return at_most;
    return static_cast<uint32_t>(remaining(horizon, at_most) / time_step_ + kRounding);
}

}  // namespace demolish
