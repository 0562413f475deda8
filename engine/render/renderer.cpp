// SPDX-License-Identifier: Apache-2.0
// One frame, as a list of passes. Computed: depths, names, cracks. Drawn: shadow map; materials of body,
// spheres and cracks. Then, in compute, occlusion and light.
#include "engine/render/renderer.h"

#include <optional>

#include "engine/gl/error.h"
#include "engine/passes/ambient_occlusion_pass.h"
#include "engine/passes/collider_pass.h"
#include "engine/passes/computed_raster.h"
#include "engine/passes/crack_pass.h"
#include "engine/passes/depth_eraser.h"
#include "engine/passes/dust_pass.h"
#include "engine/passes/dust_shadow_pass.h"
#include "engine/passes/floor_pass.h"
#include "engine/passes/glass_pass.h"
#include "engine/passes/glow_pass.h"
#include "engine/passes/grit_pass.h"
#include "engine/passes/id_pass.h"
#include "engine/passes/light_pass.h"
#include "engine/passes/relief_pass.h"
#include "engine/passes/shadow_pass.h"
#include "engine/passes/spark_pass.h"
#include "engine/passes/sphere_pass.h"
#include "engine/passes/surface_pass.h"
#include "engine/platform/gl_context.h"
#include "engine/render/render_targets.h"
#include "engine/render/seen_mesh.h"
#include "engine/render/shading_volumes.h"
#include "engine/render/shadow_scene.h"
#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

constexpr GLuint kFrameBlock = 0;
constexpr float kEmptyDepth = 0.0f;  // reversed

int shadowMapSize(RenderQuality quality) {
    return quality == RenderQuality::kFull ? 2048 : 1024;
}

}  // namespace

struct Renderer::Passes {
    Passes(const std::filesystem::path& shaders, size_t task_count)
        : shader_folder(shaders),
          raster_tasks(task_count),
          in_software(describeCurrentContext({}).software),
          relief(shaders),
          shadow(shaders),
          surface(shaders),
          spheres(shaders),
          floor(shaders),
          colliders(shaders),
          cracks(shaders),
          occlusion(shaders),
          light(shaders),
          ids(shaders),
          grit(shaders),
          dust(shaders),
          dust_shadow(shaders),
          sparks(shaders),
          glass(shaders, task_count),
          glow(shaders),
          eraser(shaders, kEmptyDepth),
          frame_block(gl::Buffer::immutable(sizeof(FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT)) {}

    void uploadFrame(const FractureMesh* mesh, const FrameView& view) {
        frame = makeFrameUniforms(view, shadowMapSize(view.quality));
        frame.floor_bounce.w = showsDust(mesh, view) ? 1.0f : 0.0f;
        frame_block.upload(std::as_bytes(std::span(&frame, 1)));
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frame_block.id());
        colliders.setColliders(view.colliders);
        kind = pictureKind(view, colliders.count() > 0);
        kind.glass = showsGlass(mesh, view);
        with_looks = showsModelLooks(mesh, view);
        if (with_looks) mesh->looks()->bind();
        kind.glow = with_looks && mesh->looks()->glows();
        sparks.prepare(kind, view.opening);
        PictureKind lit = kind;
        lit.radiance = lit.radiance || kind.glass;  // glass mixes light, and comes after
        light.prepare(view, lit, with_looks);
        occlusion.showColliders(colliders.count() > 0);
    }

    /// Software renderers fill memory faster than they look through it.
    static bool erasesTiles(const FrameView& view) { return view.quality == RenderQuality::kFull; }
    bool computes(const FractureMesh* mesh, const FrameView& view);
    template <class Prepare>
    bool unlessRefused(Prepare prepare);
    void prepareDust(const FractureMesh* mesh, const FrameView& view);
    ShadowScene shadowScene(const FractureMesh* mesh, const FrameView& view) const {
        return shadowSceneOf(mesh, view, near, sphere_draws, frame);
    }
    void draw(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer);
    void compute(const FractureMesh& mesh, const FrameView& view, GLuint framebuffer);
    void drawShadowMap(const FractureMesh* mesh, const FrameView& view);
    void drawMaterials(const FractureMesh* mesh, const FrameView& view);
    void computeLight(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer, bool found);
    void drawGlass(const FractureMesh* found, const FrameView& view, GLuint framebuffer);
    void drawLight(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer);
    void castDustShadows(const FractureMesh* mesh, const FrameView& view);
    void addUpDust(const FractureMesh* mesh, const FrameView& view);
    void drawSparks(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer);
    /// Of what is solid, for what is drawn before it; null: the depth of `targets` is.
    const gl::Texture* nearestDepth(const FrameView& view) const {
        return view.quality == RenderQuality::kFull ? &occlusion.nearestDepth() : nullptr;
    }
    IdScene idScene(const FractureMesh* mesh, std::span<const SphereDraw> projectiles, const FrameView& view);

    std::filesystem::path shader_folder;
    size_t raster_tasks;
    bool in_software;
    BodyGeometry body;
    ReliefPass relief;
    ShadowPass shadow;
    SurfacePass surface;
    SpherePass spheres;
    FloorPass floor;
    ColliderPass colliders;
    CrackPass cracks;
    AmbientOcclusionPass occlusion;
    LightPass light;
    IdPass ids;
    GritPass grit;
    DustPass dust;
    DustShadowPass dust_shadow;
    SparkPass sparks;
    GlassPass glass;
    GlowPass glow;
    std::optional<ComputedRaster> computed;  ///< made when first needed
    std::string refusal;
    DepthEraser eraser;
    ShadingVolumes volumes;
    gl::Buffer frame_block;
    FrameUniforms frame{};
    PictureKind kind;  ///< of the frame being drawn, as the next
    bool with_looks = false;
    bool chooses = false;  ///< draws what `seen` has found
    SeenMesh seen;
    const NearFaces* near = nullptr;  ///< of the frame being drawn
    std::span<const SphereDraw> sphere_draws;
    gl::PassClock clock;
    std::optional<RenderTargets> targets;
};

/// Computed pictures know one look, the same for all bodies, and no colliders of triangles.
bool Renderer::Passes::computes(const FractureMesh* mesh, const FrameView& view) {
    if (!mayCompute(view, in_software) || !showsSolid(mesh, view) || !view.more_looks.empty() ||
        view.look.variation > 0 || colliders.hasTriangles())
        return false;
    if (showsModelLooks(mesh, view) && mesh->looks()->isMasked()) return false;  // names know no holes
    return unlessRefused([&] {
        if (!ComputedRaster::suits(*mesh, targets->width, targets->height, targets->samples)) return false;
        if (!computed) computed.emplace(shader_folder, raster_tasks);
        computed->prepare(*targets, colliders.count() > 0);
        occlusion.prepareFound(*targets);
        light.prepareFound(*targets);
        return true;
    });
}

/// A driver may refuse a shader that others take: then everything is drawn.
template <class Prepare>
bool Renderer::Passes::unlessRefused(Prepare prepare) {
    if (!refusal.empty()) return false;
    try {
        return prepare();
    } catch (const gl::GlError& problem) {
        computed.reset();
        refusal = problem.what();
        return false;
    }
}

void Renderer::Passes::prepareDust(const FractureMesh* mesh, const FrameView& view) {
    const auto ready = [&](bool computes) { return dust.prepare(kind, *targets, computes), true; };
    const bool may = showsDust(mesh, view) && mayCompute(view, in_software);
    if (!may || !unlessRefused([&] { return ready(true); })) ready(false);
}

void Renderer::Passes::drawShadowMap(const FractureMesh* mesh, const FrameView& view) {
    if (shadow.holds(shadowScene(mesh, view), shadowMapSize(view.quality))) return clock.mark("shadow");
    shadow.begin(shadowMapSize(view.quality), erasesTiles(view));
    for (int region = 0; region < kShadowRegions; ++region) {
        shadow.enter(region, chooses ? seen.small() : nullptr);
        if (showsSolid(mesh, view))
            shadow.drawBody(body, *mesh, hiddenUnless(false, looksOf(view)), with_looks, near,
                            chooses ? &seen.inShadow(region) : nullptr);
        if (mesh != nullptr && view.mode == ViewMode::kParticles) spheres.drawParticleShadows(*mesh, region);
        spheres.drawSphereShadows(region);
        if (showsEffects(mesh, view)) grit.drawShadows(*mesh, region);
        colliders.drawShadows(region);
    }
    shadow.finish(erasesTiles(view));
    clock.mark("shadow");
}

void Renderer::Passes::drawMaterials(const FractureMesh* mesh, const FrameView& view) {
    // Colour is not cleared: it is read only where depth says that something was drawn.
    if (!erasesTiles(view)) eraser.forget();
    eraser.erase(targets->depth_only, targets->depth);
    targets->scene.bind();
    glDepthFunc(GL_GEQUAL);
    clock.mark("clear");
    if (showsSolid(mesh, view))
        surface.draw(body, *mesh, view, with_looks, near, chooses ? &seen : nullptr, *targets);
    if (mesh != nullptr && view.mode == ViewMode::kParticles) spheres.drawParticles(*mesh, view.colour_map);
    spheres.drawSpheres();
    colliders.drawMaterials();
    clock.mark("body");
    if (showsEffects(mesh, view)) grit.draw(*mesh, view.look);
    clock.mark("grit");
    if (kind.glow) glow.draw(body, *mesh, *targets);
    if (showsSolid(mesh, view) && view.show_cracks)
        cracks.draw(*mesh, looksOf(view), chooses ? &seen.cracks() : nullptr);
    clock.mark("cracks");
}

void Renderer::Passes::computeLight(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer,
                                    bool found) {
    const gl::Texture& visibility = occlusion.run(*targets, view.scene_radius, found);
    clock.mark("occlusion");
    const GLuint target = gl::writableTexture(framebuffer, view.width, view.height,
                                              view.radiance || kind.glass ? GL_RGBA16F : GL_RGBA8);
    const GLuint picture = target != 0 ? target : targets->display.id();
    found ? computed->bindShadowMap() : shadow.bindMap();
    addUpDust(mesh, view);
    if (found) {
        light.computeFound(*targets, visibility, view.look, picture);
        computed->leftEmpty();
    } else {
        if (kind.glow) glow.bind();
        light.compute(*targets, visibility, picture);
        ShadowPass::unbindMap();
    }
    clock.mark("light");
    if (target != 0) return;
    targets->show(framebuffer);
    clock.mark("present");
}

void Renderer::Passes::compute(const FractureMesh& mesh, const FrameView& view, GLuint framebuffer) {
    castDustShadows(&mesh, view);
    computed->run(mesh, near, spheres, colliders, *targets, shadowScene(&mesh, view),
                  shadowMapSize(view.quality), clock);
    if (view.show_cracks) computed->addCracks(mesh, *targets, view.look);
    clock.mark("cracks");
    computeLight(&mesh, view, framebuffer, true);
    drawSparks(&mesh, view, framebuffer);
}

void Renderer::Passes::draw(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer) {
    chooses = in_software && view.rasteriser == Rasteriser::kAuto && showsSolid(mesh, view);
    if (chooses)
        seen.find(*mesh, near, view, frame, *targets, shadowMapSize(view.quality), wantedOf(*mesh, view));
    clock.mark("seen");
    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    castDustShadows(mesh, view);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    drawShadowMap(mesh, view);
    const auto ready = [&] { return glass.readyToFind(*mesh, *targets); };
    const bool finds = kind.glass && mayCompute(view, in_software) && unlessRefused(ready);
    if (kind.glass) glass.castShadow(body, *mesh, frame.light_matrix[0], view, finds);
    clock.mark("glass shadow");
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    drawMaterials(mesh, view);
    if (finds) glass.find(*mesh, view, *targets);
    if (kind.glass && !finds) glass.peel(body, *mesh, view, *targets);
    clock.mark("glass");
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    const GLuint opaque = kind.glass ? glass.scene(*targets) : framebuffer;
    if (view.quality == RenderQuality::kDraft) {
        drawLight(mesh, view, opaque);
    } else {
        eraser.remember(targets->depth, targets->samples);
        clock.mark("touched");
        computeLight(mesh, view, opaque, false);
    }
    if (kind.glass) drawGlass(finds ? mesh : nullptr, view, framebuffer);
    drawSparks(mesh, view, framebuffer);
}

void Renderer::Passes::drawGlass(const FractureMesh* found, const FrameView& view, GLuint framebuffer) {
    shadow.bindMap();
    if (view.quality == RenderQuality::kDraft)
        glass.walk(*targets, view, kind, framebuffer);
    else
        glass.computeWalk(found, *targets, view, kind, framebuffer);
    ShadowPass::unbindMap();
    clock.mark("walk");
}

void Renderer::Passes::castDustShadows(const FractureMesh* mesh, const FrameView& view) {
    dust_shadow.cast(showsDust(mesh, view) && view.quality == RenderQuality::kFull ? mesh : nullptr);
}

void Renderer::Passes::addUpDust(const FractureMesh* mesh, const FrameView& view) {
    dust.addUp(showsDust(mesh, view) ? mesh : nullptr, view, *targets, nearestDepth(view));
    clock.mark("dust");
}

void Renderer::Passes::drawSparks(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer) {
    if (showsDust(mesh, view)) sparks.draw(*mesh, *targets, nearestDepth(view), framebuffer);
    clock.mark("sparks");
}

void Renderer::Passes::drawLight(const FractureMesh* mesh, const FrameView& view, GLuint framebuffer) {
    shadow.bindMap();
    addUpDust(mesh, view);
    if (kind.glow) glow.bind();
    light.draw(*targets, framebuffer);
    ShadowPass::unbindMap();
    clock.mark("light");
}

IdScene Renderer::Passes::idScene(const FractureMesh* mesh, std::span<const SphereDraw> projectiles,
                                  const FrameView& view) {
    uploadFrame(mesh, view);
    spheres.setSpheres(projectiles);
    return {mesh, body, spheres, colliders, view.show_floor ? &floor : nullptr};
}

Renderer::Renderer(const std::filesystem::path& shader_folder, size_t raster_tasks)
    : passes_(std::make_unique<Passes>(shader_folder, raster_tasks)) {
    gl::throwIfError("Setting up the renderer");
}

Renderer::~Renderer() = default;

void Renderer::draw(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view,
                    unsigned target_framebuffer) {
    Passes& p = *passes_;
    if (view.width <= 0 || view.height <= 0) return;  // a minimised window
    p.clock.begin();
    if (fitTargets(p.targets, view)) p.eraser.forget();
    p.uploadFrame(mesh, view);
    p.prepareDust(mesh, view);
    p.sphere_draws = spheres;
    p.spheres.setSpheres(spheres);
    p.volumes.bind(view);
    p.clock.mark("uploads");
    p.near = p.relief.find(mesh, view, p.frame, p.in_software);
    p.clock.mark("relief");
    if (p.computes(mesh, view))
        p.compute(*mesh, view, target_framebuffer);
    else
        p.draw(mesh, view, target_framebuffer);
    p.sphere_draws = {};
    p.clock.end();
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    ShadingVolumes::unbind();
    glBindVertexArray(0);
    glUseProgram(0);
    gl::throwIfError("Drawing a frame");
}

Pick Renderer::pick(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view,
                    int x, int y) {
    if (x < 0 || y < 0 || x >= view.width || y >= view.height) return {};
    const Pick pick = passes_->ids.pick(passes_->idScene(mesh, spheres, view), view, x, y);
    gl::throwIfError("Picking");
    return pick;
}

std::vector<uint32_t> Renderer::fragmentIds(const FractureMesh* mesh, std::span<const SphereDraw> spheres,
                                            const FrameView& view) {
    std::vector<uint32_t> ids = passes_->ids.readAll(passes_->idScene(mesh, spheres, view), view);
    gl::throwIfError("Drawing fragment ids");
    return ids;
}

double Renderer::lastDrawMs() const {
    return passes_->clock.lastMs();
}

const std::string& Renderer::refusal() const {
    return passes_->refusal;
}

std::span<const gl::PassTime> Renderer::lastPassTimes() const {
    return passes_->clock.lastPasses();
}

}  // namespace demolish::engine
