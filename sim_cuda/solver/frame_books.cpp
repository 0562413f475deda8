// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/solver/frame_books.h"

namespace demolish {

FrameBooks::FrameBooks(double time_step, double mass, uint32_t particles, uint32_t bonds) {
    stats_.time_step = time_step;
    stats_.particles = particles;
    stats_.bonds = bonds;
    stats_.mass = mass;
}

void FrameBooks::closeFrame(uint32_t substeps, double time, uint32_t list_rebuilds) {
    stats_.frame = ++state_.frames;
    stats_.substeps = substeps;
    stats_.time = time;
    stats_.list_rebuilds = list_rebuilds;
    stats_.fracture_changed = false;
}

void FrameBooks::addSums(const FrameSums& sums, bool booked, double external) {
    if (booked) {
        state_.damping += sums.damping;
        state_.friction += sums.friction;
        state_.fracture += sums.fracture;
        state_.held += sums.held;
    }
    stats_.fracture_changed = sums.broken != state_.broken;
    state_.broken = sums.broken;
    state_.parted = sums.parted;
    stats_.max_stress_ratio = sums.stress;
    tell(external);
}

void FrameBooks::tell(double external) {
    stats_.bonds_broken = state_.broken;
    stats_.bonds_parted = state_.parted;
    stats_.energy.damping = state_.damping;
    stats_.energy.friction = state_.friction;
    stats_.energy.fracture = state_.fracture;
    stats_.energy.external = external + state_.held;
}

void FrameBooks::setMechanical(const MechanicalSums& sums, double external) {
    tell(external);
    stats_.energy.external += sums.held;
    stats_.energy.damping += sums.damping;
    stats_.energy.friction += sums.friction;
    stats_.energy.fracture += sums.fracture;
    stats_.energy.kinetic = sums.kinetic;
    stats_.energy.elastic = sums.elastic;
    stats_.energy.potential = sums.potential;
    stats_.linear_momentum = {sums.linear.x, sums.linear.y, sums.linear.z};
    stats_.angular_momentum = {sums.angular.x, sums.angular.y, sums.angular.z};
}

void FrameBooks::setFragments(const FragmentSummary& summary) {
    stats_.fragments = summary.fragments;
    stats_.largest_fragment_fraction = summary.largest_mass / stats_.mass;
}

void FrameBooks::resume(const State& state, double external, double time) {
    state_ = state;
    stats_.status = StepStatus::kOk;
    stats_.frame = state.frames;
    stats_.time = time;
    stats_.energy = {};  // those of the moment are not known until they are measured
    tell(external);
}

}  // namespace demolish
