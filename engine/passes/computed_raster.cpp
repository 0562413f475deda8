// SPDX-License-Identifier: Apache-2.0
// Data-centre GPUs draw with few of their multiprocessors and compute with all, and a drawing unit wastes
// most of its lanes on triangles of a pixel's size.
#include "engine/passes/computed_raster.h"

#include <algorithm>
#include <string>

namespace demolish::engine {
namespace {

// As shaders/common/raster.glsl.
constexpr GLint kNaming = 0, kSampleAt = 1, kSampleBox = 6, kShadowTexels = 7, kShadowOffset = 8,
                kLanePixels = 9, kTaskRoom = 10, kLargeRoom = 11;
constexpr GLint kFours = 0, kCrackWidth = 0;
constexpr float kGrid = 256;
constexpr int kCoarseTexels = 64;   // shaders/common/shadow.glsl
constexpr GLuint kShadowViews = 3;  // the camera and two regions

/// Lanes go on to further work, so that these only have to fill any GPU.
constexpr GLuint kTriangleGroups = 4096, kSquareGroups = 8192, kSetupGroups = 2048, kLargeGroups = 1024,
                 kCrackGroups = 4096, kBallGroups = 64, kGritGroups = 2048, kColliderGroups = 256,
                 kClearGroups = 2048;
/// Beyond so many px of its box a triangle is shared by several lanes.
constexpr int kMostLanePixels = 24;
constexpr size_t kTaskBytes = 8, kFoundHeaderBytes = 16, kLargeBytes = 88;
constexpr GLint kBindings = static_cast<GLint>(StorageBinding::kCount);

/// Most touch one square or two.
size_t largeRoom(size_t task_room) {
    return task_room / 2;
}

/// Of triangles that were found, and later of tiles of 8 x 8 px to be lit.
size_t foundBytes(const FractureMesh& mesh, int width, int height) {
    const size_t index_bytes =
        mesh.stream(StreamId::kExteriorIndices).size() + mesh.stream(StreamId::kInteriorIndices).size();
    const size_t tiles = static_cast<size_t>((width + 7) / 8) * static_cast<size_t>((height + 7) / 8);
    return kFoundHeaderBytes + std::max(index_bytes / 3, sizeof(uint32_t) * tiles);
}

/// Depth and name a sample, cracks in two words a pixel, in whole groups of four.
size_t visibleFours(int width, int height, int samples) {
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    return (pixels * (2 * static_cast<size_t>(samples) + 2) + 3) / 4;
}

}  // namespace

ComputedRaster::ComputedRaster(const std::filesystem::path& shaders, size_t task_room)
    : shaders_(shaders),
      clear_(shaders, {"raster_clear.comp"}),
      coarse_(shaders, {"shadow_coarse.comp"}),
      tasks_(gl::Buffer::immutable(task_room * kTaskBytes)),
      large_(gl::Buffer::immutable(largeRoom(task_room) * kLargeBytes)),
      task_room_(task_room) {}

void ComputedRaster::prepare(const RenderTargets& targets, bool with_colliders) {
    programsFor(targets);
    if (with_colliders && colliders_.id() == 0) colliders_ = gl::Program(shaders_, {"raster_colliders.comp"});
}

ComputedRaster::Programs& ComputedRaster::programsFor(const RenderTargets& targets) {
    Programs& programs = programs_[targets.samples];
    if (programs.cracks.id() != 0) return programs;
    const std::string samples = "#define SAMPLES " + std::to_string(targets.samples) + "\n";
    programs = {gl::Program(shaders_, {"raster_triangles.comp"}, samples),
                gl::Program(shaders_, {"raster_setup.comp"}, samples),
                gl::Program(shaders_, {"raster_squares.comp"}, samples),
                gl::Program(shaders_, {"raster_large.comp"}, samples),
                gl::Program(shaders_, {"raster_balls.comp"}, samples),
                gl::Program(shaders_, {"raster_grit.comp"}, samples),
                gl::Program(shaders_, {"raster_cracks.comp"}, samples + "#define COMPUTED\n")};
    glm::ivec2 least(static_cast<int>(kGrid)), most(0);
    for (int i = 0; i < targets.samples; ++i) {
        const glm::vec2 place = targets.sample_position[static_cast<size_t>(i)];
        const glm::ivec2 at(glm::round(place * kGrid));
        least = glm::min(least, at);
        most = glm::max(most, at);
        for (gl::Program* program : programs.raster()) program->set(kSampleAt + i, at);
        programs.cracks.set(kSampleAt + i, place);
    }
    for (gl::Program* program : programs.raster()) {
        program->set(kSampleBox, glm::ivec4(least, most));
        program->set(kShadowOffset, glm::vec2(kShadowSlopes, kShadowSteps));
        program->set(kLanePixels, kMostLanePixels);
        program->set(kTaskRoom, static_cast<uint32_t>(task_room_));
        program->set(kLargeRoom, static_cast<uint32_t>(largeRoom(task_room_)));
    }
    return programs;
}

bool ComputedRaster::suits(const FractureMesh& mesh, int width, int height, int samples) {
    GLint bindings = 0, blocks = 0;
    GLint64 bytes = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    const size_t largest =
        std::max(16 * visibleFours(width, height, samples), foundBytes(mesh, width, height));
    return bindings >= kBindings && blocks >= kBindings && static_cast<size_t>(bytes) >= largest;
}

void ComputedRaster::makeRoom(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels) {
    const size_t visible = 16 * visibleFours(targets.width, targets.height, targets.samples);
    if (visible_.size() != visible) {
        visible_ = {};  // both at once might not fit into a small GPU
        visible_ = gl::Buffer::immutable(visible);
        visible_is_empty_ = false;
    }
    const size_t found = foundBytes(mesh, targets.width, targets.height);
    if (found_.size() < found) found_ = gl::Buffer::immutable(found);
    if (shadow_bits_.height() == shadow_texels) return;
    shadow_bits_ = gl::Texture::make2d(GL_R32UI, kShadowRegions * shadow_texels, shadow_texels);
    shadow_depth_ = gl::Texture::viewTarget(shadow_bits_, GL_R32F, 1);
    shadow_depth_.setWrap(GL_CLAMP_TO_EDGE);
    shadow_coarse_ = gl::Texture::make2d(GL_R32F, kShadowRegions * shadow_texels / kCoarseTexels,
                                         shadow_texels / kCoarseTexels);
    shadow_scene_.reset();
}

void ComputedRaster::bind(const FractureMesh& mesh, const SpherePass& balls) const {
    bindStorage(StorageBinding::kParticleFragment, mesh.stream(StreamId::kParticleFragment));
    bindStorage(StorageBinding::kTransforms, mesh.stream(StreamId::kTransforms));
    bindStorage(StorageBinding::kExteriorIndices, mesh.stream(StreamId::kExteriorIndices));
    bindStorage(StorageBinding::kInteriorIndices, mesh.stream(StreamId::kInteriorIndices));
    bindStorage(StorageBinding::kComputedExteriorVertices, mesh.exteriorVertices());
    bindStorage(StorageBinding::kInteriorVertices, mesh.stream(StreamId::kInteriorVertices));
    bindStorage(StorageBinding::kCommands, mesh.stream(StreamId::kCommands));
    bindStorage(StorageBinding::kVisible, visible_);
    bindStorage(StorageBinding::kFound, found_);
    bindStorage(StorageBinding::kTasks, tasks_);
    bindStorage(StorageBinding::kBalls, balls.spheres());
    bindStorage(StorageBinding::kLarge, large_);
    bindStorage(StorageBinding::kGrains, mesh.stream(StreamId::kGrains));
    bindStorage(StorageBinding::kEffectCommands, mesh.stream(StreamId::kEffectCommands));
    glBindImageTexture(0, shadow_bits_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

void ComputedRaster::clear(int shadow_texels) {
    clear_.set(kFours, static_cast<uint32_t>(visible_is_empty_ ? 0 : visible_.size() / 16));
    visible_is_empty_ = false;
    clear_.set(kShadowTexels, shadow_texels);
    clear_.use();
    glDispatchCompute(kClearGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void ComputedRaster::rasterise(Programs& programs, const Drawn& drawn, bool naming) {
    for (gl::Program* program : programs.raster()) program->set(kNaming, naming ? 1 : 0);
    programs.triangles.use();
    glDispatchCompute(kTriangleGroups, 1, 1);
    if (drawn.balls.sphereCount() > 0) {
        programs.balls.use();
        glDispatchCompute(kBallGroups, static_cast<GLuint>(drawn.balls.sphereCount()),
                          drawn.shadows && !naming ? kShadowViews : 1);
    }
    if (drawn.grit) {
        programs.grit.use();
        glDispatchCompute(kGritGroups, 1, 1);
    }
    if (!naming) {
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the first dispatch noted what is large
        programs.setup.use();
        glDispatchCompute(kSetupGroups, 1, 1);
        glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    programs.squares.use();
    glDispatchCompute(kSquareGroups, 1, 1);
    programs.large.use();
    glDispatchCompute(kLargeGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ComputedRaster::castColliderShadows(const ColliderPass& colliders, int shadow_texels) {
    if (colliders.count() == 0) return;
    colliders_.set(kShadowTexels, shadow_texels);
    colliders_.use();
    glDispatchCompute(kColliderGroups, static_cast<GLuint>(colliders.count()), kShadowRegions);
}

void ComputedRaster::run(const FractureMesh& mesh, const SpherePass& balls, const ColliderPass& colliders,
                         const RenderTargets& targets, const ShadowScene& scene, int shadow_texels,
                         gl::PassClock& clock) {
    makeRoom(mesh, targets, shadow_texels);
    const bool with_shadows = shadow_scene_ != scene;
    if (with_shadows) shadow_scene_ = scene;
    prepare(targets, colliders.count() > 0);
    Programs& programs = programsFor(targets);
    for (gl::Program* program : programs.raster())
        program->set(kShadowTexels, with_shadows ? shadow_texels : 0);
    bind(mesh, balls);
    clear(with_shadows ? shadow_texels : 0);
    clock.mark("clear");
    if (with_shadows) castColliderShadows(colliders, shadow_texels);
    const Drawn drawn{balls, scene.with_grit, with_shadows};
    rasterise(programs, drawn, false);
    clock.mark("depths");
    glFlush();  // the GPU begins while it is told the rest
    rasterise(programs, drawn, true);
    clock.mark("names");
    if (with_shadows) makeCoarseShadows();
    clock.mark("coarse shadow");
}

void ComputedRaster::addCracks(const FractureMesh& mesh, const RenderTargets& targets, float width) {
    bindStorage(StorageBinding::kCrackList, mesh.stream(StreamId::kCrackEdges));
    bindStorage(StorageBinding::kCrackEdges, mesh.crackEdges());
    bindStorage(StorageBinding::kExteriorVertices, mesh.exteriorVertices());
    gl::Program& program = programsFor(targets).cracks;
    program.set(kCrackWidth, width);
    program.use();
    glDispatchCompute(kCrackGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    bindStorage(StorageBinding::kInteriorIndices, mesh.stream(StreamId::kInteriorIndices));
    bindStorage(StorageBinding::kComputedExteriorVertices, mesh.exteriorVertices());
    bindStorage(StorageBinding::kInteriorVertices, mesh.stream(StreamId::kInteriorVertices));
}

void ComputedRaster::makeCoarseShadows() {
    coarse_.use();
    shadow_depth_.bind(1);
    glBindImageTexture(0, shadow_coarse_.id(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    glDispatchCompute(static_cast<GLuint>(shadow_coarse_.width()),
                      static_cast<GLuint>(shadow_coarse_.height()), 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ComputedRaster::bindShadowMap() const {
    shadow_depth_.bind(1);
    shadow_coarse_.bind(7);
}

}  // namespace demolish::engine
