// SPDX-License-Identifier: Apache-2.0
// Triangles, balls and grains into one picture: whoever is nearest to a sample gives it its name.
#include "engine/passes/computed_raster.h"

#include <algorithm>
#include <span>
#include <string>

#include "engine/passes/crack_pass.h"

namespace demolish::engine {
namespace {

constexpr GLint kSampleAt = 1, kShadowTexels = 7;  // shaders/common/raster.glsl
constexpr int kCoarseTexels = 64;                  // shaders/common/shadow.glsl
constexpr GLuint kShadowViews = 3;                 // the camera and two regions

/// Lanes go on to further work, so that these only have to fill any GPU.
constexpr GLuint kCrackGroups = 4096, kBallGroups = 64, kGritGroups = 2048, kColliderGroups = 256;

size_t pixelsOf(int width, int height) {
    return static_cast<size_t>(width) * static_cast<size_t>(height);
}
/// Of whole tiles of 8 x 8.
size_t pixelsInTiles(int width, int height) {
    return pixelsOf((width + 7) / 8 * 8, (height + 7) / 8 * 8);
}

/// Depth, name and cracks, a word each a sample, in whole groups of four.
size_t visibleFours(int width, int height, int samples) {
    return (pixelsOf(width, height) * 3 * static_cast<size_t>(samples) + 3) / 4;
}

}  // namespace

ComputedRaster::ComputedRaster(const std::filesystem::path& shaders, size_t task_room)
    : shaders_(shaders), triangles_(shaders, task_room), coarse_(shaders, {"shadow_coarse.comp"}) {}

void ComputedRaster::prepare(const RenderTargets& targets, bool with_colliders) {
    programsFor(targets);
    if (with_colliders && colliders_.id() == 0) colliders_ = gl::Program(shaders_, {"raster_colliders.comp"});
}

ComputedRaster::Programs& ComputedRaster::programsFor(const RenderTargets& targets) {
    Programs& programs = programs_[targets.samples];
    if (programs.cracks.id() != 0) return programs;
    const std::string samples = "#define SAMPLES " + std::to_string(targets.samples) + "\n";
    const std::string putting = TriangleRaster::defines() + samples;
    const std::span places(targets.sample_position.data(), static_cast<size_t>(targets.samples));
    programs = {triangles_.make("", places), gl::Program(shaders_, {"raster_balls.comp"}, putting),
                gl::Program(shaders_, {"raster_grit.comp"}, putting),
                gl::Program(shaders_, {"raster_cracks.comp"}, samples + "#define COMPUTED\n")};
    triangles_.tell(programs.balls, places);
    triangles_.tell(programs.grit, places);
    for (GLint i = 0; i < targets.samples; ++i)
        programs.cracks.set(kSampleAt + i, places[static_cast<size_t>(i)]);
    return programs;
}

bool ComputedRaster::suits(const FractureMesh& mesh, int width, int height, int samples) {
    GLint blocks = 0;
    GLint64 bytes = 0;
    glGetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
    const size_t largest = std::max(16 * visibleFours(width, height, samples),
                                    TriangleRaster::foundBytes(mesh, pixelsInTiles(width, height)));
    return hasAllBindings() && blocks >= kMostStorageBlocks && static_cast<size_t>(bytes) >= largest;
}

void ComputedRaster::makeRoom(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels) {
    const size_t visible = 16 * visibleFours(targets.width, targets.height, targets.samples);
    if (visible_.size() != visible) {
        visible_ = {};  // both at once might not fit into a small GPU
        visible_ = gl::Buffer::immutable(visible);
        visible_is_empty_ = false;
    }
    triangles_.makeRoom(mesh, pixelsInTiles(targets.width, targets.height));
    if (shadow_bits_.height() == shadow_texels) return;
    shadow_bits_ = gl::Texture::make2d(GL_R32UI, kShadowRegions * shadow_texels, shadow_texels);
    shadow_depth_ = gl::Texture::viewTarget(shadow_bits_, GL_R32F, 1);
    shadow_depth_.setWrap(GL_CLAMP_TO_EDGE);
    shadow_coarse_ = gl::Texture::make2d(GL_R32F, kShadowRegions * shadow_texels / kCoarseTexels,
                                         shadow_texels / kCoarseTexels);
    shadow_scene_.reset();
}

void ComputedRaster::bind(const FractureMesh& mesh, const NearFaces* near, const SpherePass& balls) const {
    triangles_.bind(mesh, near);
    bindStorage(StorageBinding::kVisible, visible_);
    bindStorage(StorageBinding::kBalls, balls.spheres());
    bindStorage(StorageBinding::kGrains, mesh.stream(StreamId::kGrains));
    bindStorage(StorageBinding::kEffectCommands, mesh.stream(StreamId::kEffectCommands));
    glBindImageTexture(0, shadow_bits_.id(), 0, GL_FALSE, 0, GL_READ_WRITE, GL_R32UI);
}

void ComputedRaster::clear(int shadow_texels) {
    triangles_.clear(visible_is_empty_ ? 0 : visible_.size() / 16, shadow_texels);
    visible_is_empty_ = false;
}

void ComputedRaster::rasterise(Programs& programs, const Drawn& drawn, bool naming) {
    TriangleRaster::runSmall(programs.triangles, naming);
    if (drawn.balls.sphereCount() > 0) {
        TriangleRaster::setNaming(programs.balls, naming);
        programs.balls.use();
        glDispatchCompute(kBallGroups, static_cast<GLuint>(drawn.balls.sphereCount()),
                          drawn.shadows && !naming ? kShadowViews : 1);
    }
    if (drawn.grit) {
        TriangleRaster::setNaming(programs.grit, naming);
        programs.grit.use();
        glDispatchCompute(kGritGroups, 1, 1);
    }
    TriangleRaster::runLarge(programs.triangles, naming);
}

void ComputedRaster::castColliderShadows(const ColliderPass& colliders, int shadow_texels) {
    if (colliders.casters() == 0) return;
    colliders_.set(kShadowTexels, shadow_texels);
    colliders_.use();
    glDispatchCompute(kColliderGroups, static_cast<GLuint>(colliders.casters()), kShadowRegions);
}

void ComputedRaster::run(const FractureMesh& mesh, const NearFaces* near, const SpherePass& balls,
                         const ColliderPass& colliders, const RenderTargets& targets,
                         const ShadowScene& scene, int shadow_texels, gl::PassClock& clock) {
    makeRoom(mesh, targets, shadow_texels);
    const bool with_shadows = shadow_scene_ != scene;
    if (with_shadows) shadow_scene_ = scene;
    prepare(targets, colliders.count() > 0);
    Programs& programs = programsFor(targets);
    for (gl::Program* program : programs.raster())
        program->set(kShadowTexels, with_shadows ? shadow_texels : 0);
    bind(mesh, near, balls);
    clear(with_shadows ? shadow_texels : 0);
    clock.mark("clear");
    if (with_shadows) castColliderShadows(colliders, shadow_texels);
    const Drawn drawn{balls, scene.with_grit, with_shadows};
    rasterise(programs, drawn, false);
    clock.mark("depths");
    glFlush();  // the GPU begins while it is told the rest
    if (TriangleRaster::namesLater()) rasterise(programs, drawn, true);
    clock.mark("names");
    if (with_shadows) makeCoarseShadows();
    clock.mark("coarse shadow");
}

void ComputedRaster::addCracks(const FractureMesh& mesh, const RenderTargets& targets,
                               const SurfaceLook& look) {
    bindStorage(StorageBinding::kCrackList, mesh.stream(StreamId::kCrackEdges));
    bindStorage(StorageBinding::kCrackEdges, mesh.crackEdges());
    bindStorage(StorageBinding::kExteriorVertices, mesh.exteriorVertices());
    gl::Program& program = programsFor(targets).cracks;
    setCrackLook(program, look);
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
