// SPDX-License-Identifier: Apache-2.0
// Data-centre GPUs draw with few of their multiprocessors and compute with all, and a drawing unit wastes
// most of its lanes on triangles of a pixel's size.
#include "engine/passes/triangle_raster.h"

#include <algorithm>
#include <utility>

#include "engine/gl/extension.h"
#include "engine/passes/shadow_pass.h"

namespace demolish::engine {
namespace {

// As shaders/common/raster.glsl.
constexpr GLint kNaming = 0, kSampleAt = 1, kSampleBox = 6, kShadowOffset = 8, kLanePixels = 9,
                kTaskRoom = 10, kLargeRoom = 11;
constexpr GLint kFours = 0, kShadowTexels = 7;  // shaders/raster_clear.comp
constexpr float kGrid = 256;

/// Lanes go on to further work, so that these only have to fill any GPU.
constexpr GLuint kTriangleGroups = 4096, kSquareGroups = 8192, kSetupGroups = 2048, kLargeGroups = 1024,
                 kClearGroups = 2048;
/// Beyond so many px of its box a triangle is shared by several lanes.
constexpr int kMostLanePixels = 24;
constexpr size_t kTaskBytes = 8, kFoundHeaderBytes = 16, kLargeBytes = 88;

/// Most touch one square or two.
size_t largeRoom(size_t task_room) {
    return task_room / 2;
}

}  // namespace

TriangleRaster::TriangleRaster(std::filesystem::path shaders, size_t task_room)
    : shaders_(std::move(shaders)),
      task_room_(task_room),
      clear_(shaders_, {"raster_clear.comp"}),
      tasks_(gl::Buffer::immutable(task_room * kTaskBytes)),
      large_(gl::Buffer::immutable(largeRoom(task_room) * kLargeBytes)) {
    for (gl::Buffer* buffer : {&no_near_.cells, &no_near_.indices, &no_near_.vertices})
        *buffer = gl::Buffer::zeros(2 * sizeof(NearFaces::Header));
}

bool TriangleRaster::namesLater() {
    static const bool later = !gl::hasExtension("GL_NV_shader_atomic_int64");
    return later;
}

std::string TriangleRaster::defines() {
    if (namesLater()) return "";
    return "#extension GL_NV_shader_atomic_int64 : require\n#extension GL_ARB_gpu_shader_int64 : require\n"
           "#define WIDE_ATOMICS\n";
}

TriangleRaster::Programs TriangleRaster::make(const std::string& defines,
                                              std::span<const glm::vec2> places) const {
    const std::string text =
        TriangleRaster::defines() + defines + "#define SAMPLES " + std::to_string(places.size()) + "\n";
    Programs programs = {gl::Program(shaders_, {"raster_triangles.comp"}, text),
                         gl::Program(shaders_, {"raster_setup.comp"}, text),
                         gl::Program(shaders_, {"raster_squares.comp"}, text),
                         gl::Program(shaders_, {"raster_large.comp"}, text)};
    for (gl::Program* program : {&programs.triangles, &programs.setup, &programs.squares, &programs.large})
        tell(*program, places);
    return programs;
}

void TriangleRaster::tell(gl::Program& program, std::span<const glm::vec2> places) const {
    glm::ivec2 least(static_cast<int>(kGrid)), most(0);
    GLint location = kSampleAt;
    for (const glm::vec2 place : places) {
        const glm::ivec2 at(glm::round(place * kGrid));
        least = glm::min(least, at);
        most = glm::max(most, at);
        program.set(location++, at);
    }
    program.set(kSampleBox, glm::ivec4(least, most));
    program.set(kShadowOffset, glm::vec2(kShadowSlopes, kShadowSteps));
    program.set(kLanePixels, kMostLanePixels);
    program.set(kTaskRoom, static_cast<uint32_t>(task_room_));
    program.set(kLargeRoom, static_cast<uint32_t>(largeRoom(task_room_)));
}

size_t TriangleRaster::foundBytes(const FractureMesh& mesh, size_t pixels) {
    const size_t index_bytes =
        mesh.stream(StreamId::kExteriorIndices).size() + mesh.stream(StreamId::kInteriorIndices).size();
    const size_t near_bytes = sizeof(uint32_t) * NearFaces::kMostTriangles;
    return kFoundHeaderBytes + std::max(index_bytes / 3 + near_bytes, sizeof(uint32_t) * pixels);
}

void TriangleRaster::makeRoom(const FractureMesh& mesh, size_t pixels) {
    const size_t bytes = foundBytes(mesh, pixels);
    if (found_.size() < bytes) found_ = gl::Buffer::immutable(bytes);
}

void TriangleRaster::bind(const FractureMesh& mesh, const NearFaces* near) const {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kExteriorIndices, mesh.stream(StreamId::kExteriorIndices));
    bindStorage(StorageBinding::kInteriorIndices, mesh.stream(StreamId::kInteriorIndices));
    bindStorage(StorageBinding::kComputedExteriorVertices, mesh.exteriorVertices());
    bindStorage(StorageBinding::kInteriorVertices, mesh.stream(StreamId::kInteriorVertices));
    bindStorage(StorageBinding::kCommands, mesh.stream(StreamId::kCommands));
    bindNear(near != nullptr ? *near : no_near_);
    bindStorage(StorageBinding::kFound, found_);
    bindStorage(StorageBinding::kTasks, tasks_);
    bindStorage(StorageBinding::kLarge, large_);
}

void TriangleRaster::clear(size_t fours, int shadow_texels) {
    clear_.set(kFours, static_cast<uint32_t>(fours));
    clear_.set(kShadowTexels, shadow_texels);
    clear_.use();
    glDispatchCompute(fours == 0 && shadow_texels == 0 ? 1 : kClearGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void TriangleRaster::setNaming(gl::Program& program, bool naming) {
    program.set(kNaming, naming ? 1 : 0);
}

void TriangleRaster::runSmall(Programs& programs, bool naming) {
    setNaming(programs.triangles, naming);
    programs.triangles.use();
    glDispatchCompute(kTriangleGroups, 1, 1);
}

void TriangleRaster::runLarge(Programs& programs, bool naming) {
    if (!naming) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the first dispatch noted what is large
        programs.setup.use();
        glDispatchCompute(kSetupGroups, 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    setNaming(programs.squares, naming);
    programs.squares.use();
    glDispatchCompute(kSquareGroups, 1, 1);
    setNaming(programs.large, naming);
    programs.large.use();
    glDispatchCompute(kLargeGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
}

}  // namespace demolish::engine
