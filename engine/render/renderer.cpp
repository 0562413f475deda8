// One frame, as a list of passes. The order is the order of the picture: shadow map, body, floor, spheres,
// cracks, sky, occlusion, tone map.
#include "engine/render/renderer.h"

#include <algorithm>
#include <bit>
#include <optional>

#include "engine/gl/error.h"
#include "engine/gl/timer_query.h"
#include "engine/passes/ambient_occlusion_pass.h"
#include "engine/passes/crack_pass.h"
#include "engine/passes/floor_pass.h"
#include "engine/passes/id_pass.h"
#include "engine/passes/quality_defines.h"
#include "engine/passes/shadow_pass.h"
#include "engine/passes/sky_pass.h"
#include "engine/passes/sphere_pass.h"
#include "engine/passes/surface_pass.h"
#include "engine/passes/tone_map_pass.h"
#include "engine/render/frame_uniforms.h"
#include "engine/render/noise_volume.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {
namespace {

constexpr GLuint kFrameBlock = 0, kNoiseUnit = 2;
constexpr float kTilesPerSceneRadius = 2.0f;

/// Programs whose text depends on the quality.
struct ShadedPasses {
    ShadedPasses(const std::filesystem::path& shaders, RenderQuality quality)
        : surface(shaders, quality), floor(shaders, quality), spheres(shaders, quality) {}
    SurfacePass surface;
    FloorPass floor;
    SpherePass spheres;
};

/// Tiles of a round size (1, 2 or 5 times a power of ten), about half the scene's radius.
float tileSize(float scene_radius) {
    const float wanted = std::max(scene_radius, 1e-4f) / kTilesPerSceneRadius;
    const float power = std::pow(10.0f, std::floor(std::log10(wanted)));
    const float digit = wanted / power;
    return power * (digit < 1.5f ? 1.0f : digit < 3.5f ? 2.0f : digit < 7.5f ? 5.0f : 10.0f);
}

}  // namespace

struct Renderer::Passes {
    explicit Passes(const std::filesystem::path& shader_folder)
        : shaders(shader_folder),
          shadow(shaders),
          sky(shaders),
          cracks(shaders),
          occlusion(shaders),
          tone_map(shaders),
          ids(shaders),
          noise(makeNoiseVolume()),
          frame_block(gl::Buffer::immutable(sizeof(FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT)) {
        glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
    }

    ShadedPasses& shaded(RenderQuality quality) {
        auto& slot = quality == RenderQuality::kFull ? full : draft;
        if (!slot) slot.emplace(shaders, quality);
        return *slot;
    }

    void prepareTargets(const FrameView& view) {
        const int wanted = std::clamp(view.samples, 1, std::min(4, max_samples));
        const int samples = static_cast<int>(std::bit_floor(static_cast<unsigned>(wanted)));
        if (!targets || !targets->fits(view.width, view.height, samples)) {
            targets.reset();  // both sets at once might not fit into a small GPU
            targets.emplace(view.width, view.height, samples);
        }
    }

    void uploadFrame(const FrameView& view) {
        const FrameUniforms frame = makeFrameUniforms(view, shadowMapSize(view.quality));
        frame_block.upload(std::as_bytes(std::span(&frame, 1)));
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frame_block.id());
    }

    void drawShadowMap(const FractureMesh* mesh, SpherePass& spheres, const FrameView& view);
    void drawScene(const FractureMesh* mesh, ShadedPasses& passes, const FrameView& view);

    std::filesystem::path shaders;
    int max_samples = 1;
    BodyGeometry body;
    ShadowPass shadow;
    SkyPass sky;
    CrackPass cracks;
    AmbientOcclusionPass occlusion;
    ToneMapPass tone_map;
    IdPass ids;
    gl::Texture noise;
    gl::Buffer frame_block;
    gl::TimerQuery timer;
    std::optional<ShadedPasses> full, draft;
    std::optional<RenderTargets> targets;
};

void Renderer::Passes::drawShadowMap(const FractureMesh* mesh, SpherePass& spheres, const FrameView& view) {
    shadow.begin(shadowMapSize(view.quality));
    if (mesh != nullptr) {
        if (view.mode == ViewMode::kSurface) {
            shadow.drawBody(body, *mesh);
        } else {
            spheres.drawParticleShadows(*mesh);
        }
    }
    spheres.drawSphereShadows();
    shadow.finish();
}

void Renderer::Passes::drawScene(const FractureMesh* mesh, ShadedPasses& passes, const FrameView& view) {
    targets->scene.bind();
    glViewport(0, 0, view.width, view.height);
    const float black[4] = {0, 0, 0, 0}, far_depth = 0.0f;
    glClearNamedFramebufferfv(targets->scene.id(), GL_COLOR, 0, black);
    glClearNamedFramebufferfv(targets->scene.id(), GL_DEPTH, 0, &far_depth);
    glDepthFunc(GL_GEQUAL);
    shadow.bindMap();
    noise.bind(kNoiseUnit);
    if (mesh != nullptr && view.mode == ViewMode::kSurface) passes.surface.draw(body, *mesh, view.look);
    if (mesh != nullptr && view.mode == ViewMode::kParticles)
        passes.spheres.drawParticles(*mesh, view.colour_map);
    passes.spheres.drawSpheres();
    if (view.show_floor) passes.floor.draw(tileSize(view.scene_radius));
    if (mesh != nullptr && view.mode == ViewMode::kSurface && view.show_cracks) {
        cracks.draw(*mesh, view.look.crack_width);
    }
    sky.draw();
    ShadowPass::unbindMap();
}

Renderer::Renderer(const std::filesystem::path& shader_folder)
    : passes_(std::make_unique<Passes>(shader_folder)) {
    gl::throwIfError("Setting up the renderer");
}

Renderer::~Renderer() = default;

void Renderer::draw(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view,
                    unsigned target_framebuffer) {
    Passes& p = *passes_;
    if (view.width <= 0 || view.height <= 0) return;  // a minimised window
    p.timer.begin();
    p.prepareTargets(view);
    p.uploadFrame(view);
    ShadedPasses& shaded = p.shaded(view.quality);
    shaded.spheres.setSpheres(spheres);

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    p.drawShadowMap(mesh, shaded.spheres, view);
    p.drawScene(mesh, shaded, view);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);

    const bool with_occlusion = view.quality == RenderQuality::kFull;
    const gl::Texture* visibility =
        with_occlusion ? &p.occlusion.run(*p.targets, view.scene_radius) : nullptr;
    p.tone_map.run(*p.targets, visibility);
    glBlitNamedFramebuffer(p.targets->resolved.id(), target_framebuffer, 0, 0, view.width, view.height, 0, 0,
                           view.width, view.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    p.timer.end();
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glBindVertexArray(0);
    glUseProgram(0);
    gl::throwIfError("Drawing a frame");
}

Pick Renderer::pick(const FractureMesh* mesh, std::span<const SphereDraw> spheres, const FrameView& view,
                    int x, int y) {
    if (x < 0 || y < 0 || x >= view.width || y >= view.height) return {};
    Passes& p = *passes_;
    p.uploadFrame(view);
    SpherePass& sphere_pass = p.shaded(view.quality).spheres;
    sphere_pass.setSpheres(spheres);
    FloorPass* floor = view.show_floor ? &p.shaded(view.quality).floor : nullptr;
    const Pick pick = p.ids.pick({mesh, p.body, sphere_pass, floor}, view, x, y);
    gl::throwIfError("Picking");
    return pick;
}

std::vector<uint32_t> Renderer::fragmentIds(const FractureMesh* mesh, std::span<const SphereDraw> spheres,
                                            const FrameView& view) {
    Passes& p = *passes_;
    p.uploadFrame(view);
    SpherePass& sphere_pass = p.shaded(view.quality).spheres;
    sphere_pass.setSpheres(spheres);
    FloorPass* floor = view.show_floor ? &p.shaded(view.quality).floor : nullptr;
    std::vector<uint32_t> ids = p.ids.readAll({mesh, p.body, sphere_pass, floor}, view);
    gl::throwIfError("Drawing fragment ids");
    return ids;
}

double Renderer::lastDrawMs() const {
    return passes_->timer.lastMs();
}

}  // namespace demolish::engine
