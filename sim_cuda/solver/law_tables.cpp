// SPDX-License-Identifier: Apache-2.0
// Which constants hold between whom: bodies, projectiles and colliders.
#include <algorithm>

#include "sim_cuda/physics/contact_laws.h"
#include "sim_cuda/physics/restitution.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {
namespace {

/// A landing this much slower than beta v_c, the speed whose stress breaks bonds, breaks none: a wave doubles
/// it at most where it comes back.
constexpr double kGentleShare = 0.6;

/// What one partner brings into a contact. A projectile has the surface of the first body and its own
/// stiffness factor.
struct Surface {
    double stiffness = 0, modulus = 0, poisson = 0, friction = 0, restitution = 0, rolling = 0, adhesion = 0;
    double factor = 1;
    double gentle = 0;  ///< m/s
    bool projectile = false;
};

Surface surfaceOf(const SceneSetup& setup, const SceneTables& tables,
                  const std::vector<Projectile>& projectiles, uint32_t owner) {
    const bool projectile = owner >= tables.bodies;
    const uint32_t body = projectile ? 0 : owner;
    const Material& m = setup.bodies[body].material;
    const BodyConstants& constants = tables.body[body];
    Surface surface{constants.mean_stiffness,
                    constants.report.bond_modulus,
                    m.poisson_ratio,
                    m.friction,
                    m.restitution,
                    m.rolling_friction,
                    m.adhesion_energy,
                    1,
                    projectile ? 0 : kGentleShare * m.beta * m.critical_velocity,
                    projectile};
    if (projectile && owner - tables.bodies < projectiles.size())
        surface.factor = projectiles[owner - tables.bodies].stiffness_factor;
    return surface;
}

double mean(double a, double b) {
    return (a + b) / 2;
}

void setDamping(const SolverParams& params, double restitution, PairLaw<double>& law) {
    const RestitutionConstants constants = restitutionConstants(restitution);
    law.damping = params.contact_law == ContactLaw::kHertz ? constants.hertz : constants.linear;
}

/// Two bodies in series; a projectile takes the body's constants times its factor.
PairLaw<double> pairLaw(const SolverParams& params, const Surface& a, const Surface& b) {
    const Surface& body = a.projectile ? b : a;
    const double factor = std::max(a.factor, b.factor);
    const bool hit = a.projectile || b.projectile;
    PairLaw<double> law;
    law.stiffness = factor * (hit ? body.stiffness : 2 * reduced(a.stiffness, b.stiffness));
    const double e_a = a.projectile ? body.modulus * factor : a.modulus;
    const double e_b = b.projectile ? body.modulus * factor : b.modulus;
    const ContactModuli<double> moduli = contactModuli(e_a, a.poisson, e_b, b.poisson);
    law.modulus = moduli.normal;
    law.shear_modulus = moduli.tangential;
    law.friction = hit ? body.friction : mean(a.friction, b.friction);
    law.rolling = hit ? body.rolling : mean(a.rolling, b.rolling);
    law.adhesion = hit ? 0 : mean(a.adhesion, b.adhesion);
    setDamping(params, hit ? body.restitution : mean(a.restitution, b.restitution), law);
    return law;
}

PairLaw<double> wallLaw(const SolverParams& params, const Collider& wall, const Surface& a) {
    const ContactModuli<double> moduli = rigidWallModuli(a.modulus * a.factor, a.poisson);
    PairLaw<double> law;
    law.stiffness = a.stiffness * a.factor;
    law.friction = wall.friction.value_or(params.wall_friction < 0 ? a.friction : params.wall_friction);
    law.rolling = a.rolling;
    law.adhesion = a.projectile ? 0 : a.adhesion;
    law.gentle = a.gentle;
    law.modulus = params.wall_stiffness * moduli.normal;
    law.shear_modulus = params.wall_stiffness * moduli.tangential;
    setDamping(params, wall.restitution.value_or(a.restitution), law);
    return law;
}

BodyLaw<double> bodyLaw(const BodyConstants& constants) {
    constexpr double kShares = 65535;
    return {constants.shear_ratio, constants.beta_r, constants.largest_radius / kShares,
            constants.strength_scale / kShares, constants.faces};
}

}  // namespace

LawTables buildLawTables(const SceneSetup& setup, const SceneTables& tables,
                         const std::vector<Projectile>& projectiles) {
    LawTables laws;
    for (uint32_t b = 0; b < tables.bodies; ++b) laws.body.push_back(bodyLaw(tables.body[b]));
    const uint32_t owners = tables.owners();
    for (uint32_t a = 0; a < owners; ++a) {
        const Surface surface = surfaceOf(setup, tables, projectiles, a);
        for (const Collider& wall : setup.params.colliders)
            laws.wall.push_back(wallLaw(setup.params, wall, surface));
        for (uint32_t b = 0; b < owners; ++b)
            laws.pair.push_back(pairLaw(setup.params, surface, surfaceOf(setup, tables, projectiles, b)));
    }
    return laws;
}

}  // namespace demolish
