// SPDX-License-Identifier: Apache-2.0
// Three dispatches; the GPU decides whether the second and third have anything to do.
#include "engine/passes/relief_pass.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "engine/passes/body_geometry.h"
#include "engine/render/mesh_motion.h"
#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

// shaders/common/relief.glsl, shaders/relief_*.comp
constexpr GLint kCellCount = 0, kGroupCount = 33, kRoom = 34, kLookCount = 35, kReliefOfLook = 40;
constexpr GLuint kGroups = 512, kCellLanes = 64;
constexpr size_t kSumBytes = 32;

/// Of each look its relief's height and longest waves; none of transparent ones.
std::vector<glm::vec2> reliefsOf(const FrameView& view) {
    std::vector<glm::vec2> reliefs;
    for (const SurfaceLook& look : looksOf(view))
        reliefs.emplace_back(look.isTransparent() ? 0 : look.relief_height, look.relief_size);
    return reliefs;
}

bool hasRelief(const std::vector<glm::vec2>& reliefs) {
    return std::any_of(reliefs.begin(), reliefs.end(), [](glm::vec2 relief) { return relief.x > 0; });
}

}  // namespace

ReliefPass::ReliefPass(std::filesystem::path shaders) : shaders_(std::move(shaders)) {}

const NearFaces* ReliefPass::find(const FractureMesh* mesh, const FrameView& view, const FrameUniforms& frame,
                                  bool in_software) {
    if (view.quality != RenderQuality::kFull || !showsSolid(mesh, view) || !mesh->cellSpheres())
        return nullptr;
    Key key{mesh->version(), frame.view_projection, frame.viewport, reliefsOf(view)};
    if (!hasRelief(key.reliefs)) return nullptr;
    if (key != key_) {
        makeRoom(*mesh);
        tell(key);
        run(*mesh);
        key_ = std::move(key);
        near_.version = !in_software || showsAny(near_) ? ++last_version_ : 0;
    }
    return near_.version != 0 ? &near_ : nullptr;
}

void ReliefPass::makeRoom(const FractureMesh& mesh) {
    const size_t cell_bytes = std::max<size_t>(mesh.particleCount(), 4) * sizeof(uint32_t);
    if (near_.cells.size() != cell_bytes) near_.cells = gl::Buffer::resizable(cell_bytes);
    if (near_.indices) return;
    for (const auto& [program, file] : {std::pair(&cells_, "relief_cells.comp"),
                                        {&count_, "relief_count.comp"},
                                        {&faces_, "relief_faces.comp"}})
        *program = gl::Program(shaders_, {file}, "#define COMPUTED\n");
    near_.indices =
        gl::Buffer::resizable(sizeof(NearFaces::Header) + 3 * NearFaces::kMostTriangles * sizeof(uint32_t));
    // The passes keep it: no groups is what each frame begins with.
    const NearFaces::Header nothing{0, 1, sizeof(NearFaces::Header) / sizeof(uint32_t), 0, 0, {0, 1, 1}};
    near_.indices.upload(std::as_bytes(std::span(&nothing, 1)));
    near_.vertices = gl::Buffer::resizable(NearFaces::kMostVertices * sizeof(MeshVertex));
    sums_ = gl::Buffer::resizable(kGroups * kSumBytes);
}

void ReliefPass::tell(const Key& key) {
    for (gl::Program* program : {&cells_, &count_, &faces_}) {
        program->set(kGroupCount, kGroups);
        program->set(kLookCount, static_cast<uint32_t>(key.reliefs.size()));
        for (size_t k = 0; k < key.reliefs.size(); ++k)
            program->set(kReliefOfLook + static_cast<GLint>(k), key.reliefs[k]);
    }
}

void ReliefPass::bind(const FractureMesh& mesh) const {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kInteriorIndices, mesh.stream(StreamId::kInteriorIndices));
    bindStorage(StorageBinding::kCellSpheres, mesh.cellSpheres());
    bindStorage(StorageBinding::kInteriorVertices, mesh.stream(StreamId::kInteriorVertices));
    bindStorage(StorageBinding::kCommands, mesh.stream(StreamId::kCommands));
    bindStorage(StorageBinding::kReliefSums, sums_);
    bindStorage(StorageBinding::kComputedCellLooks, mesh.cellLooks());
    bindStorage(StorageBinding::kNearCells, near_.cells);
    bindStorage(StorageBinding::kNearIndices, near_.indices);
    bindStorage(StorageBinding::kNearVertices, near_.vertices);
}

void ReliefPass::run(const FractureMesh& mesh) {
    bind(mesh);
    const auto cells = static_cast<uint32_t>(mesh.particleCount());
    cells_.set(kCellCount, cells);
    cells_.use();
    glDispatchCompute((cells + kCellLanes - 1) / kCellLanes, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT);
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, near_.indices.id());
    count_.use();
    glDispatchComputeIndirect(offsetof(NearFaces::Header, groups));
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    faces_.set(kRoom, glm::uvec2(NearFaces::kMostTriangles, NearFaces::kMostVertices));
    faces_.use();
    glDispatchComputeIndirect(offsetof(NearFaces::Header, groups));
    glBindBuffer(GL_DISPATCH_INDIRECT_BUFFER, 0);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                    GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT |
                    GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace demolish::engine
