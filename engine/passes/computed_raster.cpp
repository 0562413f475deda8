// Data-centre GPUs draw with few of their multiprocessors and compute with all, and a drawing unit wastes
// most of its lanes on triangles of a pixel's size.
#include "engine/passes/computed_raster.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace demolish::engine {
namespace {

// As shaders/common/raster.glsl.
constexpr GLint kNaming = 0, kSampleCount = 1, kSampleAt = 2, kSampleBox = 6, kShadowTexels = 7,
                kShadowOffset = 8, kMostPixels = 9, kTaskRoom = 11;
constexpr GLint kFours = 0, kCrackWidth = 0;
constexpr float kGrid = 256;
constexpr int kNearShadows = 3;  // views: the camera and two regions

/// Lanes go on to further work, so that these only have to fill any GPU.
constexpr GLuint kTriangleGroups = 2048, kSquareGroups = 4096, kCrackGroups = 1024, kBallGroups = 64;
/// Beyond so many px of its box a triangle is shared by several lanes.
constexpr int kLanePixels = 48;
constexpr size_t kTaskCount = size_t{1} << 19, kTaskBytes = 8, kFoundHeaderBytes = 8;
constexpr GLint kBindings = static_cast<GLint>(StorageBinding::kCount);

size_t triangleRoom(const FractureMesh& mesh) {
    const size_t indices =
        mesh.stream(StreamId::kExteriorIndices).size() + mesh.stream(StreamId::kInteriorIndices).size();
    return indices / (3 * sizeof(uint32_t)) + 1;
}

/// Depth and name a sample, cracks in two words a pixel, in whole groups of four.
size_t visibleFours(int width, int height, int samples) {
    const size_t pixels = static_cast<size_t>(width) * static_cast<size_t>(height);
    return (pixels * (2 * static_cast<size_t>(samples) + 2) + 3) / 4;
}

glm::ivec2 onGrid(glm::vec2 place) {
    return glm::ivec2(glm::round(place * kGrid));
}

}  // namespace

ComputedRaster::ComputedRaster(const std::filesystem::path& shaders)
    : clear_(shaders, {"raster_clear.comp"}),
      triangles_(shaders, {"raster_triangles.comp"}),
      squares_(shaders, {"raster_squares.comp"}),
      balls_(shaders, {"raster_balls.comp"}),
      cracks_(shaders, {"raster_cracks.comp"}, "#define COMPUTED\n"),
      tasks_(gl::Buffer::immutable(kTaskCount * kTaskBytes)) {
    for (gl::Program* program : {&triangles_, &squares_}) {
        program->set(kShadowOffset, glm::vec2(kShadowSlopes, kShadowSteps));
        program->set(kTaskRoom, static_cast<uint32_t>(kTaskCount));
    }
    triangles_.set(kMostPixels, kLanePixels);
}

bool ComputedRaster::suits(const FractureMesh& mesh, int width, int height, int samples) {
    GLint bindings = 0, blocks = 0;
    GLint64 bytes = 0;
    glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &bindings);
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    const size_t largest = std::max(16 * visibleFours(width, height, samples),
                                    kFoundHeaderBytes + sizeof(uint32_t) * triangleRoom(mesh));
    return bindings >= kBindings && blocks >= kBindings && static_cast<size_t>(bytes) >= largest;
}

void ComputedRaster::makeRoom(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels) {
    const size_t visible = 16 * visibleFours(targets.width, targets.height, targets.samples);
    if (visible_.size() != visible) {
        visible_ = {};  // both at once might not fit into a small GPU
        visible_ = gl::Buffer::immutable(visible);
    }
    const size_t found = kFoundHeaderBytes + sizeof(uint32_t) * triangleRoom(mesh);
    if (found_.size() < found) found_ = gl::Buffer::immutable(found);
    if (shadow_bits_.height() == shadow_texels) return;
    shadow_bits_ = gl::Texture::make2d(GL_R32UI, kShadowRegions * shadow_texels, shadow_texels);
    shadow_depth_ = gl::Texture::viewTarget(shadow_bits_, GL_R32F, 1);
    shadow_depth_.setWrap(GL_CLAMP_TO_EDGE);
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
    glBindImageTexture(0, shadow_bits_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

void ComputedRaster::setViews(const RenderTargets& targets, int shadow_texels) {
    glm::ivec2 least(static_cast<int>(kGrid)), most(0);
    for (int i = 0; i < targets.samples; ++i) {
        const glm::ivec2 at = onGrid(targets.sample_position[static_cast<size_t>(i)]);
        least = glm::min(least, at);
        most = glm::max(most, at);
    }
    for (gl::Program* program : {&triangles_, &squares_, &balls_}) {
        program->set(kSampleCount, targets.samples);
        for (int i = 0; i < targets.samples; ++i)
            program->set(kSampleAt + i, onGrid(targets.sample_position[static_cast<size_t>(i)]));
        program->set(kSampleBox, glm::ivec4(least, most));
        program->set(kShadowTexels, shadow_texels);
    }
}

void ComputedRaster::clear(int shadow_texels) {
    clear_.set(kFours, static_cast<uint32_t>(visible_.size() / 16));
    clear_.set(kShadowTexels, shadow_texels);
    clear_.use();
    glDispatchCompute(kTriangleGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

void ComputedRaster::rasterise(const SpherePass& balls, bool naming, bool with_shadows) {
    for (gl::Program* program : {&triangles_, &squares_, &balls_}) program->set(kNaming, naming ? 1 : 0);
    triangles_.use();
    glDispatchCompute(kTriangleGroups, 1, 1);
    if (balls.sphereCount() > 0) {
        balls_.use();
        glDispatchCompute(kBallGroups, static_cast<GLuint>(balls.sphereCount()),
                          with_shadows ? kNearShadows : 1);
    }
    if (!naming) glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the first dispatch wrote the tasks
    squares_.use();
    glDispatchCompute(kSquareGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                    GL_TEXTURE_FETCH_BARRIER_BIT);
}

void ComputedRaster::run(const FractureMesh& mesh, const SpherePass& balls, const RenderTargets& targets,
                         const ShadowScene& scene, int shadow_texels, gl::PassClock& clock) {
    makeRoom(mesh, targets, shadow_texels);
    const bool with_shadows = shadow_scene_ != scene;
    if (with_shadows) shadow_scene_ = scene;
    bind(mesh, balls);
    setViews(targets, with_shadows ? shadow_texels : 0);
    clear(with_shadows ? shadow_texels : 0);
    clock.mark("clear");
    rasterise(balls, false, with_shadows);
    clock.mark("depths");
    rasterise(balls, true, false);
    clock.mark("names");
}

void ComputedRaster::addCracks(const FractureMesh& mesh, const RenderTargets& targets, float width) {
    bindStorage(StorageBinding::kCrackList, mesh.stream(StreamId::kCrackEdges));
    bindStorage(StorageBinding::kCrackEdges, mesh.crackEdges());
    bindStorage(StorageBinding::kExteriorVertices, mesh.exteriorVertices());
    cracks_.set(kCrackWidth, width);
    cracks_.set(kSampleCount, targets.samples);
    for (int i = 0; i < targets.samples; ++i)
        cracks_.set(kSampleAt + i, targets.sample_position[static_cast<size_t>(i)]);
    cracks_.use();
    glDispatchCompute(kCrackGroups, 1, 1);
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    bindStorage(StorageBinding::kInteriorIndices, mesh.stream(StreamId::kInteriorIndices));
    bindStorage(StorageBinding::kComputedExteriorVertices, mesh.exteriorVertices());
    bindStorage(StorageBinding::kInteriorVertices, mesh.stream(StreamId::kInteriorVertices));
}

void ComputedRaster::bindShadowMap() const {
    shadow_depth_.bind(1);
}

}  // namespace demolish::engine
