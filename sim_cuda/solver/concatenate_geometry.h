// SPDX-License-Identifier: Apache-2.0
// The draw data of all bodies of a scene as one: particles, pool, faces, bonds and exterior numbered through.
#pragma once
#include <vector>

#include "sim_cuda/api/solver.h"

namespace demolish {

/// Rest positions stay in each body's own frame: the transform of a fragment includes the placement of its
/// body.
struct SceneGeometry {
    FractureGeometry geometry;        ///< cells, bonds, pool, vertices and faces numbered through the scene
    std::vector<float> pool_spacing;  ///< m, h of the body of each pool vertex
    std::vector<float> pool_waves;    ///< m, height of the waves of its breaks
};

SceneGeometry concatenateGeometry(const std::vector<BodyInstance>& bodies);

}  // namespace demolish
