// SPDX-License-Identifier: Apache-2.0
// How stiff and strong the bonds of one body are: its material, softened to what the time step bears.
#pragma once
#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/solver/scene_tables.h"

namespace demolish {

/// Modulus with which the highest frequency is found before the true one is known.
inline constexpr double kTrialModulus = 1e7;  // Pa

/// m, of the bonds' mean area: where (13) is the strength that the report shows; 1 without bonds.
double meanBondRadius(const BreakableBody& body);
/// Of a bond whose area and length are set, at this modulus (Pa).
BondStiffness<double> stiffnessOf(const Material& material, const BondGeometry& bond, double modulus);
/// k_T / k_N: of the beam law a free choice.
double shearRatio(const Material& material);
/// Of the strength that holds the critical velocity; in steps of 1/256, the same on every machine, whatever
/// its pow() gives.
double thinWallShareOf(const BreakableBody& body);
/// By so much less than its material says a body breaks where paint weakens it most.
double weakestPainted(const BreakableBody& body);
/// Modulus, strength and damping from the step of dt s (softened) or from the material. trial_omega: rad/s,
/// highest frequency at the trial modulus.
BodyConstants bodyConstants(const BodyInstance& instance, const SolverParams& params, double trial_omega,
                            double dt);

}  // namespace demolish
