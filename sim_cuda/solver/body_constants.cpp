// SPDX-License-Identifier: Apache-2.0
// The softening rule of one body: models E.1 and E.2.
#include "sim_cuda/solver/body_constants.h"

#include <algorithm>
#include <cmath>

#include "sim_cuda/physics/softening.h"
#include "sim_cuda/physics/time_step.h"

namespace demolish {
namespace {

/// E_eff / E of spheres bonded across gaps at 8.5 bonds a particle and a* = 0.5 (physics A.3, test D.14).
constexpr double kSpheresModulusShare = 0.66;

/// E_eff of a body with bonds of this modulus, Pa.
double effectiveModulusOf(const Material& material, double bond_modulus) {
    switch (material.bond_law) {
        case BondLaw::kBeam:
            return effectiveModulus(bond_modulus, material.shear_ratio);
        case BondLaw::kPaper:
            return effectiveModulusPaper(bond_modulus);
        case BondLaw::kSpheres:
            break;
    }
    return kSpheresModulusShare * bond_modulus;
}

}  // namespace

double meanBondRadius(const BreakableBody& body) {
    double area = 0;
    for (const BondGeometry& bond : body.bonds) area += bond.area;
    return area > 0 ? faceBondRadius(area / static_cast<double>(body.bonds.size())) : 1;
}

BondStiffness<double> stiffnessOf(const Material& material, const BondGeometry& bond, double modulus) {
    if (material.bond_law == BondLaw::kBeam)
        return beamBond(modulus, bond.area, bond.length, material.shear_ratio);
    const double radius = faceBondRadius(bond.area);
    const double ratio =
        material.bond_law == BondLaw::kSpheres ? material.bond_ratio : faceRatioNeck(radius, bond.length);
    return paperBond(modulus, material.poisson_ratio, ratio, radius);
}

double shearRatio(const Material& material) {
    if (material.bond_law == BondLaw::kBeam) return material.shear_ratio;
    return paperShearRatio(material.poisson_ratio);
}

double thinWallShareOf(const BreakableBody& body) {
    if (!(body.mesh_area > 0)) return 1;  // particles without a surface
    return std::round(256 * thinWallShare(cellsThroughWall(body.mesh_volume, body.mesh_area, body.spacing))) /
           256;
}

/// sigma_c, Pa, of a bond of mean area: (13), or
/// the rule that holds the critical velocity.
static double strengthOf(const BodyInstance& instance, const SofteningReport& report) {
    const Material& material = instance.material;
    if (material.fracture_energy > 0)
        return griffithStrength(report.bond_modulus, material.poisson_ratio, material.fracture_energy,
                                meanBondRadius(*instance.body));
    return thinWallShareOf(*instance.body) *
           bondStrength(material.beta, material.density, report.wave_speed, material.critical_velocity);
}

/// Pa: with it the body is as stiff as the material.
static double realBondModulus(const Material& material) {
    return material.bond_law == BondLaw::kSpheres ? material.youngs_modulus
                                                  : material.youngs_modulus / effectiveModulusOf(material, 1);
}

/// Pa: the most that the step bears.
static double softenedBondModulus(const BodyInstance& instance, double safety, double trial_omega,
                                  double dt) {
    if (trial_omega > 0) return bondModulusForStep(kTrialModulus, trial_omega, safety, dt);
    // No bonds: c_eff = kappa sf h / dt with the kappa of solid bodies (E.1).
    const Material& material = instance.material;
    const double speed = 0.68 * safety * instance.body->spacing / dt;
    return material.density * speed * speed / effectiveModulusOf(material, 1);
}

double weakestPainted(const BreakableBody& body) {
    const std::vector<double>& painted = body.bond_strength;
    return painted.empty() ? 1 : *std::min_element(painted.begin(), painted.end());
}

BodyConstants bodyConstants(const BodyInstance& instance, const SolverParams& params, double trial_omega,
                            double dt) {
    const Material& material = instance.material;
    const double safety = std::min(params.step_safety, dampedStepShare(material.damping_ratio));
    BodyConstants constants;
    SofteningReport& report = constants.report;
    report.bond_modulus = realBondModulus(material);
    if (params.soften)
        report.bond_modulus =
            std::min(report.bond_modulus, softenedBondModulus(instance, safety, trial_omega, dt));
    report.effective_modulus = effectiveModulusOf(material, report.bond_modulus);
    report.wave_speed = waveSpeed(report.effective_modulus, material.density);
    report.strength = strengthOf(instance, report);
    report.strain_at_failure = strainAtFailure(report.strength, report.effective_modulus);
    report.highest_frequency = trial_omega * std::sqrt(report.bond_modulus / kTrialModulus);
    constants.shear_ratio = shearRatio(material);
    constants.faces = {material.friction, material.rolling_friction, material.adhesion_energy};
    if (report.highest_frequency > 0)
        constants.beta_r = stiffnessDamping(material.damping_ratio, report.highest_frequency);
    return constants;
}

}  // namespace demolish
