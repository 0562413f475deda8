// SPDX-License-Identifier: Apache-2.0
// How many triangles a picture of the body holds.
#pragma once
#include <cstddef>
#include <cstdint>

namespace demolish {
namespace engine {
class FractureMesh;
}

class TriangleCounter {
  public:
    /// Exterior, exposed interior faces and the two of each crack line; 0 without a mesh. Reads the draw
    /// list's counts back from the GPU when the number of broken bonds says that they changed, and only then:
    /// call it outside of what is timed.
    uint64_t count(const engine::FractureMesh* mesh, uint32_t bonds_broken);

  private:
    const engine::FractureMesh* mesh_ = nullptr;
    size_t particles_ = 0;  ///< of the mesh: another one may stand at the same address
    uint32_t bonds_broken_ = 0;
    uint64_t count_ = 0;
};

}  // namespace demolish
