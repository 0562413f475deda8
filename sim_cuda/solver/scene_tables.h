// SPDX-License-Identifier: Apache-2.0
// A scene set-up worked out for the solver, on the host and in double: particles, bond rows, law constants,
// time step.
#pragma once
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/data/bonds.h"
#include "sim_cuda/data/particles.h"
#include "sim_cuda/kernels/step_params.h"

namespace demolish {

/// What the softening rule gave one body (models E.1, E.2), and what its law needs.
struct BodyConstants {
    SofteningReport report;
    double beta_r = 0;            ///< s, (E3)
    double shear_ratio = 0;       ///< k_T / k_N of the law in force
    double mean_stiffness = 0;    ///< N/m, mean k_N: the stiffness of plain contacts
    double largest_radius = 0;    ///< m, a_b
    double largest_strength = 0;  ///< s_b
    double strength_scale = 0;    ///< Pa, of a bond of that factor
    FaceLaw<double> faces;        ///< of its broken bonds
};

/// One direction of a bond, or of the record of two cells of different bodies that face each other.
struct BondSlot {
    uint32_t other = 0;    ///< particle at the other end
    Vec3<double> rest;     ///< m, from the row's particle to the other, body frame
    double stiffness = 0;  ///< N/m, k_N
    double radius = 0;     ///< m, a_b
    double strength = 1;   ///< s_b
    bool is_bond = true;

    /// `apart`: m, to the other particle when the two touch, in the world.
    static BondSlot facing(uint32_t other, const Vec3<double>& apart) {
        return {other, apart, 0, 0, 0, false};
    }
};

struct SceneTables {
    ParticleCounts counts;
    uint32_t bodies = 0;
    uint32_t owners() const { return bodies + kMaxProjectiles; }
    // per particle (in bodies)
    std::vector<double> mass, inertia, contact_radius, floor_radius;
    std::vector<uint32_t> owner, buried;
    static constexpr uint32_t kNoAnchor = 0xffffffffu;
    std::vector<uint32_t>
        anchor;  ///< number of the anchor that holds it, or kNoAnchor; none: nothing is held
    std::vector<Vec3<double>> position, velocity, spin;  ///< world frame
    std::vector<Quat<double>> rotation;
    std::vector<CornerRow<double>> corner_row;
    std::vector<Vec3<double>> corner;  ///< m, from the seed, body frame; once for all bodies of a shape
    // bonds of all bodies, and records of cells that face each other
    std::vector<uint32_t> row_start;  ///< total + 1
    std::vector<BondSlot> slots;
    std::vector<uint32_t> slot_of_bond, twin;
    std::vector<BodyConstants> body;
    double spacing = 0;         ///< m, smallest h of the bodies
    double largest_radius = 0;  ///< m, of contact_radius
    double mass_in_bodies = 0;  ///< kg
    double time_step = 0;       ///< s
    double contact_cap = 0;     ///< 1/s^2: a plain contact is at most this times m_e stiff
    uint32_t substeps = 0;      ///< per frame of params.frame_time
};

/// Substeps of a frame in slow motion, at least one.
uint32_t slowedSubsteps(uint32_t substeps, double time_scale);

/// Throws Cancelled when the callback says so.
SceneTables buildSceneTables(const SceneSetup& setup, const ProgressCallback& progress);

/// Throws UsageError with one sentence that names the value and its range, InputFileError where a body starts
/// inside a collider: files alone place them.
void checkSetup(const SceneSetup& setup);
void checkProjectile(const Projectile& projectile);
void checkStart(const Projectile& projectile, const std::vector<Collider>& colliders);

/// Half the distance to the nearest seed of the same body, m: no two particles of a body overlap at rest,
/// whether bonded or not (physics A.6, models E.4). At most the radius of a ball of the cell's volume: of a
/// slender cell it would stick out, and push with a lever that its inertia is too small for.
std::vector<double> contactRadii(const BreakableBody& body);
/// Makes contact radii smaller where particles of different bodies overlap: no two bodies begin pressed into
/// each other.
void keepBodiesApart(SceneTables& tables);
/// Does the anchor reach a particle of body number `body` that is there (m) at the start, with this contact
/// radius (m)?
bool reaches(const Anchor& anchor, uint32_t body, const Vec3<double>& point, double radius);
/// Who is held; of all velocities at the start those of what is held are none. Throws InputFileError when an
/// anchor holds nothing.
void holdAnchored(const SceneSetup& setup, SceneTables& tables);
/// m, how far a particle reaches towards colliders: to its farthest corner. Without corners the depth of its
/// seed, but at most the sphere of equal volume.
std::vector<double> floorRadii(const BreakableBody& body);

/// 1 for a particle whose whole cell lies between bonded neighbours, deeper than the spacing: nothing from
/// outside can touch it while these bonds hold.
std::vector<uint32_t> buriedParticles(const BreakableBody& body);

/// Highest frequency of M^-1 K, rad/s, by power iteration over a body's rows (models E.1); `first` is the
/// body's first particle. The same for any number of threads.
double highestFrequency(const SceneTables& tables, uint32_t first, uint32_t count, double shear_ratio);

/// Law tables on all owners, for the projectiles fired so far (slot p has projectiles[p]).
struct LawTables {
    std::vector<BodyLaw<double>> body;
    std::vector<PairLaw<double>> pair, wall;  ///< owners x owners; owners x colliders
};
LawTables buildLawTables(const SceneSetup& setup, const SceneTables& tables,
                         const std::vector<Projectile>& projectiles);

}  // namespace demolish
