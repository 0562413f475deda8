// SPDX-License-Identifier: Apache-2.0
// A fracture surface on the CPU with streams of its own, and what a renderer would make of them.
#pragma once
#include <memory>
#include <vector>

#include "sim_cuda/api/solver.h"
#include "sim_cuda/backend/cpu_backend.h"
#include "sim_cuda/solver/fracture_surface.h"
#include "tests/unit/draw/fragment_surfaces.h"

namespace demolish::test {

/// Fragment slots are 0, 1, 2 ... in these tests; bonds between different fragments count as broken.
class DrawnSurface {
  public:
    static constexpr float kOpening = 0.25f;

    explicit DrawnSurface(const SceneSetup& setup);

    /// Fragment of each particle; `cracked` bonds are broken though their cells may still hang together.
    void show(const std::vector<uint32_t>& fragment, const std::vector<uint32_t>& cracked = {});
    void writeStreams();
    /// As the surface is told of `fragments` and `broken`.
    Fracture fracture();

    /// Exterior and streamed triangles of each fragment.
    std::vector<Soup> soups(uint32_t fragment_count) const;
    size_t cells() const { return cells_; }
    double spacing() const { return spacing_; }  ///< m, of the first body
    double volume() const { return volume_; }    ///< m^3, of all bodies
    std::vector<Float3> positions() { return backend.downloaded(surface.positions()); }

    SceneGeometry scene;
    CpuBackend backend;
    FractureSurface<CpuBackend> surface;
    std::vector<uint32_t> fragments;
    std::vector<uint32_t> fragment_sizes;  ///< cells of each fragment
    std::vector<uint8_t> broken;
    std::vector<std::pair<uint32_t, uint32_t>> bond_cells;
    std::vector<SurfaceVertex> vertices, outside;
    std::vector<uint32_t> chunks;
    bool fresh = true;  ///< the streams hold nothing yet
    std::vector<uint32_t> indices, exterior;
    std::vector<float> openings;  ///< m, of bonds: kOpening where they are broken
    std::vector<CrackLine> cracks;
    DrawCommands commands{};

  private:
    size_t cells_ = 0;
    double spacing_ = 0, volume_ = 0;
};

/// A scene of one body standing at its own origin.
SceneSetup sceneOf(std::shared_ptr<const BreakableBody> body);

}  // namespace demolish::test
