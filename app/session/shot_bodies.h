// SPDX-License-Identifier: Apache-2.0
// The list of a shot's bodies: which are alike, and what each is made from.
#pragma once
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/authoring.h"

namespace demolish {

inline constexpr size_t kMaxModels = 64, kMaxMaterials = 32;  ///< of one scene

/// The shot's list; one body at the origin where it has none.
std::vector<SceneBody> bodiesOf(const Shot& shot);

/// Of each body the first one that is made alike: another place, motion or variant makes no difference.
std::vector<size_t> firstAlike(const std::vector<SceneBody>& bodies);

/// The first body that is like the one which the fastest ball hits. Threshold, report and panels are about
/// it.
size_t subjectOf(const Shot& shot);

/// What of its model file the body is.
ModelPart partOf(const Shot& shot, const SceneBody& body);

/// The shot with model, material and look of one of its bodies as its own.
Shot asOf(const Shot& shot, const SceneBody& body);

/// How the body's model is to be read; without a body that of the subject.
MeshPlacement placementOf(const Shot& shot, const SceneBody& body);
MeshPlacement placementOf(const Shot& shot);

/// Particles of a body, as chosen, else by device; without a body of the subject. Throws UsageError when a
/// size gives too few or too many.
uint32_t particlesWanted(const Shot& shot, const SceneBody& body, const SolidMesh& mesh, bool on_gpu);
uint32_t particlesWanted(const Shot& shot, const SolidMesh& mesh, bool on_gpu);

/// How the body is to be filled, in any place; with the body's variant in the seed. Throws as
/// particlesWanted().
FillOptions fillOptionsOf(const Shot& shot, const SceneBody& body, const SolidMesh& mesh, bool on_gpu);
/// True if tough cells are made together with the cells, and not drawn by the solver.
bool laysToughCells(const Shot& shot);

/// Of all bodies together: a scene's triangles are indexed by 32 bits, with some 135 indices a particle.
inline constexpr uint32_t kMaxSceneParticles = 16'000'000;
/// Throws UsageError where these, one a body, are more than that together.
void requireFewEnough(const std::vector<uint32_t>& particles);

/// Looks of the shot's bodies, each once, the shot's own first; they keep their places while only the shot's
/// own look changes.
struct ShotLooks {
    std::vector<engine::SurfaceLook> looks;
    std::vector<uint32_t> of_body;  ///< index into looks; of a hidden body one that is not there
    std::vector<size_t> example;    ///< of each look a body that has it
    bool areSeveral() const { return looks.size() > 1; }
};
ShotLooks looksOf(const Shot& shot);

/// Its own name; else that of its node or its model, and its number where there are several.
std::string nameOf(const Shot& shot, size_t body);

}  // namespace demolish
