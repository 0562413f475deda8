// SPDX-License-Identifier: Apache-2.0
// The laws that run in kernels, as these tests call them: on the host or on the GPU (on_device.h).
#pragma once
#include "sim_cuda/kernels/step_params.h"
#include "sim_cuda/kernels/touch_pair.h"
#include "sim_cuda/physics/bond_stiffness.h"
#include "sim_cuda/physics/hand_over.h"
#include "sim_cuda/physics/pair_state.h"
#include "sim_cuda/physics/paper_forms.h"
#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/rigid_fit.h"
#include "sim_cuda/physics/rigid_motion.h"
#include "tests/physics/laws/on_device.h"

namespace demolish::laws {

DEMOLISH_LAW(inverseSqrt)
DEMOLISH_LAW(squareRoot)
DEMOLISH_LAW(exponential)
DEMOLISH_LAW(advanced)
DEMOLISH_LAW(relativeRotation)
DEMOLISH_LAW(rotate)
DEMOLISH_LAW(multiply)
DEMOLISH_LAW(bondDeformation)
DEMOLISH_LAW(bondRates)
DEMOLISH_LAW(bondLoad)
DEMOLISH_LAW(damperLoad)
DEMOLISH_LAW(roundBond)
DEMOLISH_LAW(tensileSeverity)
DEMOLISH_LAW(shearSeverity)
DEMOLISH_LAW(bondSeverity)
DEMOLISH_LAW(severityLimit)
DEMOLISH_LAW(bondBreaks)
DEMOLISH_LAW(bondEnergy)
DEMOLISH_LAW(nextState)
DEMOLISH_LAW(brokenOverlap)
DEMOLISH_LAW(brokenRepulsion)
DEMOLISH_LAW(frictionLimit)
DEMOLISH_LAW(fractureEnergy)
DEMOLISH_LAW(bondEffect)
DEMOLISH_LAW(bondDamping)
DEMOLISH_LAW(bondRelease)
DEMOLISH_LAW(contactModuli)
DEMOLISH_LAW(rigidWallModuli)
DEMOLISH_LAW(reduced)
DEMOLISH_LAW(contactRadius)
DEMOLISH_LAW(hertzForce)
DEMOLISH_LAW(mindlinStiffness)
DEMOLISH_LAW(hertzDamping)
DEMOLISH_LAW(linearDamping)
DEMOLISH_LAW(repulsion)
DEMOLISH_LAW(adhesionForce)
DEMOLISH_LAW(tangentialSpring)
DEMOLISH_LAW(turnedIntoPlane)
DEMOLISH_LAW(rollingTorque)
DEMOLISH_LAW(contactTouchLaw)
DEMOLISH_LAW(touchEffect)
DEMOLISH_LAW(pairInertia)
DEMOLISH_LAW(massOf)
DEMOLISH_LAW(massCentre)
DEMOLISH_LAW(meanVelocity)
DEMOLISH_LAW(spinOf)
DEMOLISH_LAW(rigidMotion)
DEMOLISH_LAW(velocityAt)
DEMOLISH_LAW(solveSymmetric)
DEMOLISH_LAW(spinAt)
DEMOLISH_LAW(counterHash)
DEMOLISH_LAW(uniformOf)
DEMOLISH_LAW(innerEnergy)
DEMOLISH_LAW(wakeSpeed)
DEMOLISH_LAW(crossingLoss)
DEMOLISH_LAW(softeningLoss)
DEMOLISH_LAW(overlapBefore)
DEMOLISH_LAW(overlapChange)
DEMOLISH_LAW(touchEnergy)
DEMOLISH_LAW(brokenTouchLaw)
DEMOLISH_LAW(cappedFaces)

// Forms of the paper for comparison.
DEMOLISH_LAW_OF(paper, stretchLimit)
DEMOLISH_LAW_OF(paper, isDiscrete)
DEMOLISH_LAW_OF(paper, discreteShare)
DEMOLISH_LAW_OF(paper, cappedBendingMoment)

}  // namespace demolish::laws
