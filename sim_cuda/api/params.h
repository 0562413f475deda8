// SPDX-License-Identifier: Apache-2.0
// The knobs of a simulation: SI units, usual range, effect. Values: assets/materials and assets/scenes.
#pragma once
#include <concepts>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sim_cuda/api/collider_mesh.h"
#include "sim_cuda/api/effects.h"
#include "sim_cuda/api/vectors.h"

namespace demolish {

enum class BondLaw : uint32_t {
    kBeam,     ///< models.md E1-E4, a = 0.3: the default
    kPaper,    ///< the paper's (5)-(10) on the face, reading P2: a* = a_b / sqrt(L^2/4 + a_b^2)
    kSpheres,  ///< the paper's (5)-(10) between spheres that a gap parts: a* = bond_ratio, a_b from the
               ///< bond's area, E of a bond = E of the material when softening is off
};
enum class ContactLaw : uint32_t {
    kLinear,  ///< k_contact = mean k_N of the body: the default for scenes
    kHertz,   ///< (1')-(4')
};

struct Material {
    std::string name = "ceramic";
    double density = 2400;           ///< kg/m^3, bulk (models.md E)
    double youngs_modulus = 70e9;    ///< Pa, of the real material; only shown, and used when softening is off
    double tensile_strength = 40e6;  ///< Pa, of the real material; only shown
    double poisson_ratio = 0.25;     ///< 0..0.49, of the paper's law and of Hertz contacts
    double friction = 0.5;           ///< mu, 0..1.5
    double restitution = 0.1;        ///< e, 0.05..0.95
    double rolling_friction = 0.3;   ///< mu_r, 0..1 (models.md E.5)
    double damping_ratio = 0.3;      ///< zeta_m of the highest mode, 0.05..0.6 (E3)
    double critical_velocity = 2.5;  ///< m/s, v_c of sigma_c = beta rho c_eff v_c (models.md E.2)
    double beta = 0.4;               ///< calibration factor of E.2, 0.3..0.8
    double weibull_modulus = 0;      ///< per-bond strength scatter; 0 = off, 3..15
    uint32_t tough_cells = 40;       ///< K per body, 0 = none
    double tough_factor = 3;         ///< ci: strength of bonds inside one tough cell
    double adhesion_energy = 0;      ///< w, J/m^2, 0 = off
    BondLaw bond_law = BondLaw::kBeam;
    double shear_ratio = 0.3;    ///< a = k_T / k_N of the beam law, 0..1
    double bond_ratio = 0.5;     ///< a* of BondLaw::kSpheres, 0.1..0.9
    double fracture_energy = 0;  ///< Gamma, J/m^2: every bond as strong as (13) says; 0: as beta and v_c say
    Debris debris;
    double break_waves = 0;  ///< height of waves on large breaks, over h, 0..0.6; drawn alone

    bool operator==(const Material&) const = default;
};

/// In one run, fired later ones included.
inline constexpr uint32_t kMaxProjectiles = 32;

/// A rigid sphere. It takes part in contacts from `start_time` on.
struct Projectile {
    Double3 position;             ///< m, at start_time
    Double3 velocity;             ///< m/s
    double radius = 0.05;         ///< m
    double density = 7800;        ///< kg/m^3, iron
    double stiffness_factor = 3;  ///< times the body's k_contact
    double start_time = 0;        ///< s
};

/// Rigid half space: solid where dot(normal, x) < offset.
struct Plane {
    Double3 normal{0, 1, 0};  ///< unit
    double offset = 0;        ///< m
    bool operator==(const Plane&) const = default;
};

/// Rigid box.
struct Box {
    Double3 size{1, 1, 1};  ///< m, edges along the axes of its own frame
    Double3 position;       ///< m, of its centre
    Quaternion rotation;    ///< unit, from its own frame to the world
    bool operator==(const Box&) const = default;
};

/// Rigid ball.
struct Sphere {
    double radius = 0.5;  ///< m
    Double3 position;     ///< m, of its centre
    bool operator==(const Sphere&) const = default;
};

/// Rigid rod with round ends: all points within `radius` of the line between two points.
struct Capsule {
    double radius = 0.1;        ///< m
    Double3 from, to{0, 1, 0};  ///< m, not the same
    bool operator==(const Capsule&) const = default;
};

/// Rigid body of any closed mesh.
struct MeshShape {
    std::shared_ptr<const ColliderMesh> mesh;  ///< not null
    double scale = 1;                          ///< m a length of the mesh's own frame
    Double3 position;                          ///< m, of that frame's origin
    Quaternion rotation;                       ///< unit, from that frame to the world
    bool operator==(const MeshShape&) const = default;
};

/// What bodies fall on and are thrown against, and nothing moves. All but meshes are convex.
struct Collider {
    using Shape = std::variant<Plane, Box, Sphere, Capsule, MeshShape>;
    Shape shape;
    /// Of whatever touches it, in place of what the scene and the material say: mu, 0..1.5; e, 0.05..1.
    std::optional<double> friction, restitution;
    std::optional<Float3> colour;  ///< linear, for whoever draws it; none: the floor's

    constexpr Collider() = default;
    template <class Of>
    requires std::convertible_to<Of, Shape>
    constexpr Collider(const Of& of) : shape(of) {}
    bool operator==(const Collider&) const = default;
};
inline constexpr uint32_t kMaxColliders = 8;

/// How a body is cut into pieces beforehand. Sizes are in those of the mean piece, (V / tough_cells)^(1/3).
enum class Pattern : uint32_t {
    kUniform,    ///< pieces of one size, round
    kRadial,     ///< small round the axis and ever larger away from it, drawn out from it; in three layers
    kSlabs,      ///< across the axis
    kBricks,     ///< courses across the axis, half a brick against each other
    kSplinters,  ///< along the axis
};

/// Instead of breaking by their bonds, bodies come apart into the pieces of a pattern when something meets
/// them faster than their threshold: all bonds between pieces break at once and none inside a piece ever
/// does. Everything moves as rigid bodies, and no bond is stepped. Needs hand_over.
struct PresetPieces {
    Pattern pattern = Pattern::kUniform;
    /// Centred on the first touch, its axis along the way of what came; else as each body was cut before:
    /// centred in its box, the axis upright.
    bool at_impact = false;

    bool operator==(const PresetPieces&) const = default;
};

struct SolverParams {
    double frame_time = 1.0 / 60;  ///< s simulated per frame
    uint32_t substeps = 300;       ///< per frame of 1/60 s; sets the softened stiffness (models.md E.1)
    bool soften = true;            ///< false: stiffness from youngs_modulus, the time step follows
    double step_safety = 0.5;      ///< of dt_crit, <= 0.5 at damping_ratio 0.3
    Double3 gravity{0, -9.81, 0};  ///< m/s^2
    ContactLaw contact_law = ContactLaw::kLinear;
    std::vector<Collider> colliders{Plane{}};  ///< at most kMaxColliders
    double wall_friction = -1;                 ///< mu against colliders, 0..1.5; negative: the body's own
    double wall_stiffness = 1;   ///< Hertz: share of a rigid wall's E* and G*; 1/2: the wall is of the
                                 ///< body's own material, as (1) reads at R* = R
    double settle_time = 0;      ///< s of settling before frame 0 (models.md E.4), 0 = none
    double settle_damping = 12;  ///< 1/s, at which velocities decay meanwhile
    double scene_radius = 1000;  ///< m; particles beyond it stop the run with kLeftScene
    uint64_t seed = 1;
    bool ledger = true;      ///< book damping and friction work every substep
    bool hand_over = false;  ///< fragments that no longer vibrate move as rigid bodies (16)-(18)
    bool sleeping = false;   ///< what rests costs nothing until something comes near
    std::optional<PresetPieces> preset_pieces;
    bool smooth_cracks = true;  ///< false: faces and outlines of cracks are drawn as the cells are
    EffectsSettings effects;
};

}  // namespace demolish
