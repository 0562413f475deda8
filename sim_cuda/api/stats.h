// SPDX-License-Identifier: Apache-2.0
// What a step reports: counts, energies and status bits that name the knob to turn.
#pragma once
#include <cstdint>
#include <string>

#include "sim_cuda/api/vectors.h"

namespace demolish {

/// Bits; several may be set. A set bit stops the step and leaves the frame before it untouched on screen.
enum class StepStatus : uint32_t {
    kOk = 0,
    kNotFinite = 1u << 0,  ///< a NaN or infinity: lower --impact-velocity or raise --substeps
    kLeftScene = 1u << 1,  ///< something flew beyond SolverParams::scene_radius
};
inline StepStatus operator|(StepStatus a, StepStatus b) {
    return static_cast<StepStatus>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}
inline bool has(StepStatus set, StepStatus bit) {
    return (static_cast<uint32_t>(set) & static_cast<uint32_t>(bit)) != 0;
}
/// One sentence for people: what happened and which knob to turn. "ok" when nothing did.
std::string describe(StepStatus status);

/// J. The first six together less `external` stay what they were at the start (physics.md D.20).
struct EnergyLedger {
    double kinetic = 0, elastic = 0, potential = 0;
    double damping = 0, friction = 0, fracture = 0;  ///< dissipated since the start
    /// Work put in since the start: impacts fired, settling, what leads anchors along their paths. Of what is
    /// held, neither motion nor height counts.
    double external = 0;
};

struct FrameStats {
    StepStatus status = StepStatus::kOk;
    uint64_t frame = 0;
    double time = 0;        ///< s simulated
    double time_step = 0;   ///< s, one substep
    uint32_t substeps = 0;  ///< in the last frame
    uint32_t particles = 0, bonds = 0, bonds_broken = 0;
    /// Of the broken ones: the two ends have left each other, and no faces of the crack touch any more.
    uint32_t bonds_parted = 0;
    uint32_t fragments = 0;
    double largest_fragment_fraction = 1;  ///< of the mass
    uint32_t awake_particles = 0;   ///< that cost anything in the last frame: bonded_particles and rigid ones
    uint32_t bonded_particles = 0;  ///< stepped with their bonds
    uint32_t carried_particles = 0;   ///< of rigid fragments, that may touch those
    uint32_t awake_bodies = 0;        ///< with at least one awake particle
    uint32_t rigid_fragments = 0;     ///< moved by (16)-(18)
    uint32_t sleeping_fragments = 0;  ///< that cost nothing
    uint32_t list_rebuilds = 0;       ///< neighbour lists built in the last frame
    double mass = 0;                  ///< kg, without projectiles
    Double3 linear_momentum;          ///< kg m/s, with projectiles
    Double3 angular_momentum;         ///< kg m^2/s about the origin, with projectiles
    EnergyLedger energy;
    double max_stress_ratio = 0;    ///< highest bond stress over strength in the last substep
    bool fracture_changed = false;  ///< a bond broke in the last frame
    bool effects_shown = false;     ///< there may be grit, dust or sparks to draw
    bool effects_moving = false;    ///< and they may move in the next frame
};

}  // namespace demolish
