// SPDX-License-Identifier: Apache-2.0
// Makes the broken faces near the camera finer and moves them by the material's relief, in compute passes
// whose work is that of what is near: a lane looks at each cell, and at triangles only where one is near.
#pragma once
#include <filesystem>
#include <vector>

#include "engine/gl/program.h"
#include "engine/render/fracture_mesh.h"
#include "engine/render/frame_uniforms.h"
#include "engine/render/near_faces.h"

namespace demolish::engine {

class ReliefPass {
  public:
    explicit ReliefPass(std::filesystem::path shaders);
    /// Of what a frame shows of a mesh, which may be null. Null: no look has relief, or nothing is near as
    /// far as the CPU knows. Bound are the frame's uniforms and the noise volume. `in_software`: the CPU may
    /// look.
    const NearFaces* find(const FractureMesh* mesh, const FrameView& view, const FrameUniforms& frame,
                          bool in_software);

  private:
    struct Key {
        uint64_t mesh_version = 0;
        glm::mat4 view_projection{0};
        glm::vec4 viewport{0};
        std::vector<glm::vec2> reliefs;
        bool operator==(const Key&) const = default;
    };
    void makeRoom(const FractureMesh& mesh);
    void tell(const Key& key);
    void bind(const FractureMesh& mesh) const;
    void run(const FractureMesh& mesh);

    std::filesystem::path shaders_;
    gl::Program cells_, count_, faces_;  ///< made when first needed
    gl::Buffer sums_;
    NearFaces near_;
    Key key_;
    uint64_t last_version_ = 0;
};

}  // namespace demolish::engine
