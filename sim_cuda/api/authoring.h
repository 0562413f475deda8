// SPDX-License-Identifier: Apache-2.0
// Mesh in, breakable body out. Host code on oneTBB; the same result for any number of threads.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/mesh_repair.h"
#include "sim_cuda/api/model_part.h"
#include "sim_cuda/api/paint.h"
#include "sim_cuda/api/solver.h"

namespace demolish {

/// A closed triangle mesh with what authoring precomputes once per mesh (BVH, distance grid). Opaque here.
class SolidMesh;

struct SolidMeshInfo {
    std::string name;
    size_t triangles = 0, vertices = 0;  ///< after welding by position
    double volume = 0, area = 0;         ///< m^3, m^2
    Double3 bounds_min, bounds_max;      ///< m
};

struct MeshPlacement {
    double height = 1.0;      ///< m, the file's mesh is scaled to it; with keep_units times its own lengths
    bool keep_units = false;  ///< metres where the format says its unit, else part.unit, else metres
    ModelPart part = {};
    RepairOptions repair = {};
};

/// m, what a placement's height is of: the height, or the longest side of what is lower than a twentieth of
/// it, since a plate that lies flat has no height to go by.
double sizeToScale(const Double3& size);
/// m, a length of 1 of a file's mesh of this size, y up: the height over sizeToScale(); with keep_units the
/// metres in a length of the file, times the height. Throws UsageError for a height that is not positive.
double placementScale(const Double3& size, const MeshPlacement& placement);

/// Loads any file that assimp reads, welds, repairs what is not closed, and stands it on the floor (lowest
/// y = 0, centred in x and z). Throws InputFileError with one sentence: unreadable, no such part, no
/// triangles, and what the repair could not or may not mend: open edges (with their count), triangles that
/// are there twice, zero or negative volume.
std::shared_ptr<const SolidMesh> loadSolidMesh(const std::filesystem::path& file,
                                               const MeshPlacement& placement = {});
const SolidMeshInfo& meshInfo(const SolidMesh& mesh);
/// What was done to close it; thickness in metres of the placed body.
const RepairReport& repairReport(const SolidMesh& mesh);
/// Of the model file; null: it says nothing of its looks.
const ModelLooks* modelLooks(const SolidMesh& mesh);

/// m: `share` (0 to 1) of the surface lies over walls that are thinner than this, measured straight inwards
/// at some 4,000 points.
double thinWall(const SolidMesh& mesh, double share);

inline constexpr uint32_t kMinParticles = 2, kMaxParticles = 4'000'000;

/// Tough cells (models E.3) that are laid into a body while it is filled. Else the solver draws them.
struct ToughCellOptions {
    uint32_t cells = 0;  ///< K; 0, 1, or as many as particles: the solver draws them after all
    /// Their shape; none: irregular, round seeds drawn from the packing. Of a pattern about as many as K;
    /// radial ones lie round the aim, all others in the middle of the body.
    std::optional<Pattern> pattern = std::nullopt;
    Double3 axis{0, 1, 0};  ///< of the pattern, body frame; any length but 0
    bool conform = false;   ///< cells of particles follow their borders (geometry 1.1)
    bool operator==(const ToughCellOptions&) const = default;
};

/// Where something is to hit the body: the place of its surface that a line meets first, or a wall across it.
struct ShotAim {
    Double3 way{0, 0, -1};  ///< the line's, body frame; any length but 0
    std::optional<Double3> through =
        std::nullopt;   ///< m, body frame; none: the middle of the body at `height`
    double height = 0;  ///< m
    bool is_wall = false;
    bool operator==(const ShotAim&) const = default;
};

struct FillOptions {
    uint32_t particles = 1000;  ///< N; see particlesForSize
    uint64_t seed = 1;
    bool draw_geometry = true;  ///< false: no FractureGeometry, for what is not drawn
    std::optional<ToughCellOptions> tough = std::nullopt;
    std::optional<PaintedStrength> painted = std::nullopt;  ///< none: what is painted is only seen
    /// Spacing of cells far from the aim, or deep below it, over the spacing there: 1 (all alike) to 4.
    double refine = 1;
    ShotAim aim = {};  ///< of radial tough cells and of `refine`
    bool operator==(const FillOptions&) const = default;
};

/// N = round(V / h^3). Throws UsageError when outside kMinParticles..kMaxParticles, naming the possible
/// sizes.
uint32_t particlesForSize(const SolidMesh& mesh, double particle_size_m);

/// Packing, cells, bonds, draw data (geometry.md 1-6). Where cells come out open or without volume and the
/// mesh may be repaired, it gets a new surface and is filled again: BreakableBody::remeshed. Throws
/// Cancelled, UsageError when options.particles is out of range, InputFileError when the walls are too thin
/// to hold any particle or cells stay without volume.
std::shared_ptr<const BreakableBody> fillWithParticles(const SolidMesh& mesh, const FillOptions& options,
                                                       const ProgressCallback& progress = {});

}  // namespace demolish
