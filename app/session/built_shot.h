// SPDX-License-Identifier: Apache-2.0
// A shot made ready to run: mesh, cells, solver, and the state that a reset returns to.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

struct BuiltShot {
    Shot shot;  ///< with the strength that Shot::break_at asks for
    std::shared_ptr<const SolidMesh> mesh;
    std::vector<std::shared_ptr<const BreakableBody>> variants;  ///< one filling a variant of Shot::bodies
    std::shared_ptr<const BreakableBody> body;                   ///< the first of them
    SceneSetup setup;
    std::unique_ptr<Solver> solver;
    Snapshot start;  ///< settled, before a ball is fired
    double build_seconds = 0;
    bool has_draw_geometry = true;
};

struct BuildOptions {
    bool draw_geometry = true;
    bool ledger = true;  ///< book damping and friction work in every substep, asked for or not
    /// Parts that may be taken over instead of made again: the mesh if file, height and repair agree, the
    /// body if all that shapes it agrees.
    const BuiltShot* reuse = nullptr;
};

/// True if the shot is to run on the GPU; throws DeviceError when it was asked for and there is none.
bool choosesCuda(const Shot& shot);

/// Puts in the velocity that Impact::times_threshold asks for, and clears it: from what the shot is to break
/// at, else from the table's prediction, or from the material's critical velocity where that is more, since
/// a slower ball only punches holes into thin walls. As it is where nothing hits. Throws InputFileError (the
/// table).
void chooseVelocity(Shot& shot, const BreakableBody& body);

/// Of all bodies together: a scene's triangles are indexed by 32 bits, with some 135 indices a particle.
inline constexpr uint32_t kMaxSceneParticles = 16'000'000;

/// Particles of each body: as chosen, else by device. Throws UsageError when a size gives too few or too
/// many, or when they are too many for all bodies together.
uint32_t particlesWanted(const Shot& shot, const SolidMesh& mesh, bool on_gpu);

/// All but solver and start: mesh, cells, set-up. Throws as buildShot().
BuiltShot prepareShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress);
/// The rest of it.
void makeSolver(BuiltShot& built, const ProgressCallback& progress);
/// Both. Throws the errors of authoring and solver; Cancelled when `progress` says so.
BuiltShot buildShot(const Shot& shot, const BuildOptions& options, const ProgressCallback& progress);

}  // namespace demolish
