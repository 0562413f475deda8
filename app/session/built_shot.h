// SPDX-License-Identifier: Apache-2.0
// A shot made ready to run: mesh, cells, solver, and the state that a reset returns to.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/session/body_fillings.h"
#include "app/session/shot.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

struct BuiltShot {
    Shot shot;  ///< with the strength that Shot::break_at asks for
    BodyFillings cells;
    std::shared_ptr<const BreakableBody> body;  ///< of the subject: subjectOf()
    SceneSetup setup;
    std::unique_ptr<Solver> solver;
    Snapshot start;  ///< settled, before a ball is fired
    double build_seconds = 0;
    bool has_draw_geometry = true;
};

struct BuildOptions {
    bool draw_geometry = true;
    bool ledger = true;  ///< book damping and friction work in every substep, asked for or not
    /// Its cells may be taken over instead of made again: meshes of which file, height and repair agree,
    /// fillings of which all agrees that shapes them.
    const BuiltShot* reuse = nullptr;
};

/// True if the shot is to run on the GPU; throws DeviceError when it was asked for and there is none.
bool choosesCuda(const Shot& shot);

/// Puts in the velocity that Impact::times_threshold asks for, and clears it: from what the shot is to break
/// at, else from the table's prediction, or from the material's critical velocity where that is more, since
/// a slower ball only punches holes into thin walls. As it is where nothing hits. Throws InputFileError (the
/// table).
void chooseVelocity(Shot& shot, const BreakableBody& body);

/// All but solver and start: mesh, cells, set-up. Throws as buildShot().
BuiltShot prepareShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress);
/// The rest of it.
void makeSolver(BuiltShot& built, const ProgressCallback& progress);
/// Both. Throws the errors of authoring and solver; Cancelled when `progress` says so.
BuiltShot buildShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress);

}  // namespace demolish
