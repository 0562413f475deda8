// SPDX-License-Identifier: Apache-2.0
// A mesh's streams as the CPU reads them: the same bytes, and the same motion, as in
// shaders/common/body.glsl.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/packing.hpp>
#include <span>

#include "engine/gl/buffer.h"
#include "engine/render/fracture_mesh.h"

namespace demolish::engine {

struct MeshVertex {
    glm::vec3 position;  ///< m, at rest
    uint32_t normal, place, cell;
};
struct MeshTransform {
    glm::vec4 rotation;  ///< unit quaternion x y z w
    glm::vec3 translation;
    uint32_t age_shrink;
};
static_assert(sizeof(MeshVertex) == 24 && sizeof(MeshTransform) == 32);

inline glm::vec3 rotated(const glm::vec4& quaternion, const glm::vec3& v) {
    const glm::vec3 q(quaternion);
    return v + 2.0f * glm::cross(q, glm::cross(q, v) + quaternion.w * v);
}

/// From MeshVertex::normal, as shaders/common/gbuffer.glsl has it.
inline glm::vec3 normalOf(uint32_t octahedral) {
    const glm::vec2 e = glm::unpackSnorm2x16(octahedral);
    glm::vec3 n(e, 1 - std::abs(e.x) - std::abs(e.y));
    const float fold = std::max(-n.z, 0.0f);
    n.x += n.x >= 0 ? -fold : fold;
    n.y += n.y >= 0 ? -fold : fold;
    return glm::normalize(n);
}

/// What moves a mesh's cells, read where it lies for as long as this lives.
class MeshMotion {
  public:
    explicit MeshMotion(const FractureMesh& mesh)
        : slots_(mesh.stream(StreamId::kParticleFragment)), transforms_(mesh.stream(StreamId::kTransforms)) {}

    uint32_t fragmentOf(uint32_t cell) const { return slots_.as<uint32_t>()[cell]; }
    const MeshTransform& transformOf(uint32_t fragment) const {
        return transforms_.as<MeshTransform>()[fragment];
    }
    static glm::mat4 matrixOf(const MeshTransform& t) {
        glm::mat4 m(1);
        for (int axis = 0; axis < 3; ++axis) {
            glm::vec3 unit(0);
            unit[axis] = scaleOf(t);
            m[axis] = glm::vec4(rotated(t.rotation, unit), 0);
        }
        m[3] = glm::vec4(t.translation, 1);
        return m;
    }
    static glm::vec3 moved(const MeshTransform& t, const glm::vec3& p) {
        return rotated(t.rotation, scaleOf(t) * p) + t.translation;
    }

  private:
    static float scaleOf(const MeshTransform& t) {
        constexpr float kShrinkStep = 1.0f / 256;
        return 1 - kShrinkStep * static_cast<float>(t.age_shrink >> 24);
    }
    gl::BufferReading slots_, transforms_;
};

/// How many elements or instances one of a mesh's commands draws.
struct MeshCommand {
    uint32_t count, instances, first, base_vertex, base_instance;
};
static_assert(sizeof(MeshCommand) == kDrawCommandBytes);
inline MeshCommand commandOf(const FractureMesh& mesh, uint32_t command) {
    return gl::BufferReading(mesh.stream(StreamId::kCommands)).as<MeshCommand>()[command];
}

}  // namespace demolish::engine
