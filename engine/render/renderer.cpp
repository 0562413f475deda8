// One frame, as a list of passes: shadow map; then materials of body, spheres, floor and cracks; then, in
// compute, occlusion and light.
#include "engine/render/renderer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>

#include "engine/gl/error.h"
#include "engine/passes/ambient_occlusion_pass.h"
#include "engine/passes/crack_pass.h"
#include "engine/passes/depth_eraser.h"
#include "engine/passes/floor_pass.h"
#include "engine/passes/id_pass.h"
#include "engine/passes/light_pass.h"
#include "engine/passes/shadow_pass.h"
#include "engine/passes/sphere_pass.h"
#include "engine/passes/surface_pass.h"
#include "engine/passes/triangle_culler.h"
#include "engine/render/frame_uniforms.h"
#include "engine/render/noise_volume.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {
namespace {

constexpr GLuint kFrameBlock = 0, kNoiseUnit = 2;
constexpr float kEmptyDepth = 0.0f;  // reversed

int shadowMapSize(RenderQuality quality) {
    return quality == RenderQuality::kFull ? 2048 : 1024;
}

}  // namespace

struct Renderer::Passes {
    explicit Passes(const std::filesystem::path& shaders)
        : shadow(shaders),
          surface(shaders),
          spheres(shaders),
          floor(shaders),
          cracks(shaders),
          occlusion(shaders),
          light(shaders),
          ids(shaders),
          culler(shaders),
          eraser(shaders, kEmptyDepth),
          noise(makeNoiseVolume()),
          frame_block(gl::Buffer::immutable(sizeof(FrameUniforms), nullptr, GL_DYNAMIC_STORAGE_BIT)) {
        glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
        draft_noise.set(GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
        draft_noise.set(GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    }

    void prepareTargets(const FrameView& view) {
        const int wanted = std::clamp(view.samples, 1, std::min(4, max_samples));
        const int samples = static_cast<int>(std::bit_floor(static_cast<unsigned>(wanted)));
        if (!targets || !targets->fits(view.width, view.height, samples)) {
            targets.reset();  // both sets at once might not fit into a small GPU
            targets.emplace(view.width, view.height, samples);
            eraser.forget();
        }
    }

    void uploadFrame(const FrameView& view) {
        frame = makeFrameUniforms(view, shadowMapSize(view.quality));
        frame_block.upload(std::as_bytes(std::span(&frame, 1)));
        glBindBufferBase(GL_UNIFORM_BUFFER, kFrameBlock, frame_block.id());
    }

    /// Software renderers fill memory faster than they look through it.
    static bool erasesTiles(const FrameView& view) { return view.quality == RenderQuality::kFull; }
    /// Software renderers draw small triangles about as fast as they compute whether to.
    static bool culls(const FractureMesh& mesh, const FrameView& view) {
        return view.quality == RenderQuality::kFull && view.cull_triangles && TriangleCuller::suits(mesh);
    }
    ShadowScene shadowScene(const FractureMesh* mesh, const FrameView& view) const;
    void chooseTriangles(const FractureMesh* mesh, const FrameView& view);
    void drawShadowMap(const FractureMesh* mesh, const FrameView& view);
    void drawMaterials(const FractureMesh* mesh, const FrameView& view);
    void computeLight(const FrameView& view, GLuint framebuffer);
    void drawLight(GLuint framebuffer);
    IdScene idScene(const FractureMesh* mesh, std::span<const SphereDraw> projectiles, const FrameView& view);

    BodyGeometry body;
    std::array<BodyTriangles, static_cast<size_t>(CulledView::kCount)>
        triangles{};  ///< of the frame's surface
    ShadowPass shadow;
    SurfacePass surface;
    SpherePass spheres;
    FloorPass floor;
    CrackPass cracks;
    AmbientOcclusionPass occlusion;
    LightPass light;
    IdPass ids;
    TriangleCuller culler;
    DepthEraser eraser;
    gl::Texture noise;
    gl::Sampler draft_noise;  ///< half the texels: software renderers feel it in every pixel
    gl::Buffer frame_block;
    FrameUniforms frame{};
    std::span<const SphereDraw> sphere_draws;  ///< of the frame being drawn
    gl::PassClock clock;
    std::optional<RenderTargets> targets;
    int max_samples = 1;
};

void Renderer::Passes::chooseTriangles(const FractureMesh* mesh, const FrameView& view) {
    triangles.fill({});
    if (mesh == nullptr || view.mode != ViewMode::kSurface) return;
    triangles.fill(allTriangles(*mesh));
    if (!culls(*mesh, view)) return;
    culler.run(*mesh, *targets, shadowMapSize(view.quality));
    for (uint32_t i = 0; i < triangles.size(); ++i) triangles[i] = culler.triangles(CulledView{i});
    clock.mark("cull");
}

ShadowScene Renderer::Passes::shadowScene(const FractureMesh* mesh, const FrameView& view) const {
    ShadowScene scene;
    scene.mesh_version = mesh != nullptr ? mesh->version() : 0;
    scene.as_particles = view.mode == ViewMode::kParticles;
    scene.culled = mesh != nullptr && culls(*mesh, view);
    for (const SphereDraw& sphere : sphere_draws) {
        scene.spheres.insert(scene.spheres.end(), std::begin(sphere.position), std::end(sphere.position));
        scene.spheres.push_back(sphere.radius);
    }
    std::copy(std::begin(frame.light_matrix), std::end(frame.light_matrix), scene.light_matrix);
    return scene;
}

void Renderer::Passes::drawShadowMap(const FractureMesh* mesh, const FrameView& view) {
    if (shadow.holds(shadowScene(mesh, view), shadowMapSize(view.quality))) return clock.mark("shadow");
    shadow.begin(shadowMapSize(view.quality), erasesTiles(view));
    for (int region = 0; region < kShadowRegions; ++region) {
        shadow.enter(region);
        const CulledView of_region = region == 0 ? CulledView::kNearShadow : CulledView::kFarShadow;
        if (mesh != nullptr && view.mode == ViewMode::kSurface)
            shadow.drawBody(body, triangles[static_cast<size_t>(of_region)]);
        if (mesh != nullptr && view.mode == ViewMode::kParticles) spheres.drawParticleShadows(*mesh, region);
        spheres.drawSphereShadows(region);
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
    if (mesh != nullptr && view.mode == ViewMode::kSurface)
        surface.draw(body, triangles[static_cast<size_t>(CulledView::kCamera)], view.look);
    if (mesh != nullptr && view.mode == ViewMode::kParticles) spheres.drawParticles(*mesh, view.colour_map);
    spheres.drawSpheres();
    clock.mark("body");
    const bool with_cracks = mesh != nullptr && view.mode == ViewMode::kSurface && view.show_cracks;
    if (with_cracks) cracks.draw(*mesh, view.look.crack_width);
    clock.mark("cracks");
}

void Renderer::Passes::computeLight(const FrameView& view, GLuint framebuffer) {
    eraser.remember(targets->depth, targets->samples);
    clock.mark("touched");
    const gl::Texture& visibility = occlusion.run(*targets, view.scene_radius);
    clock.mark("occlusion");
    const GLuint picture = gl::writableTexture(framebuffer, view.width, view.height);
    shadow.bindMap();
    light.compute(*targets, visibility, picture != 0 ? picture : targets->display.id());
    ShadowPass::unbindMap();
    clock.mark("light");
    if (picture != 0) return;
    glBlitNamedFramebuffer(targets->resolved.id(), framebuffer, 0, 0, view.width, view.height, 0, 0,
                           view.width, view.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    clock.mark("present");
}

void Renderer::Passes::drawLight(GLuint framebuffer) {
    shadow.bindMap();
    light.draw(*targets, framebuffer);
    ShadowPass::unbindMap();
    clock.mark("light");
}

IdScene Renderer::Passes::idScene(const FractureMesh* mesh, std::span<const SphereDraw> projectiles,
                                  const FrameView& view) {
    uploadFrame(view);
    spheres.setSpheres(projectiles);
    return {mesh, body, spheres, view.show_floor ? &floor : nullptr};
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
    p.clock.begin();
    p.prepareTargets(view);
    p.uploadFrame(view);
    p.sphere_draws = spheres;
    p.spheres.setSpheres(spheres);
    p.noise.bind(kNoiseUnit);
    if (view.quality == RenderQuality::kDraft) p.draft_noise.bind(kNoiseUnit);
    p.clock.mark("uploads");

    glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    p.chooseTriangles(mesh, view);
    p.drawShadowMap(mesh, view);
    p.drawMaterials(mesh, view);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);

    if (view.quality == RenderQuality::kFull)
        p.computeLight(view, target_framebuffer);
    else
        p.drawLight(target_framebuffer);
    p.sphere_draws = {};
    p.clock.end();
    glBindFramebuffer(GL_FRAMEBUFFER, target_framebuffer);
    glBindSampler(kNoiseUnit, 0);
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

std::array<uint64_t, 3> Renderer::lastTriangles() const {
    std::array<uint64_t, 3> counts{};
    for (size_t view = 0; view < counts.size(); ++view) {
        if (passes_->triangles[view].mesh == nullptr) continue;
        for (const TriangleList& list :
             {passes_->triangles[view].exterior, passes_->triangles[view].interior}) {
            uint32_t indices = 0;
            list.commands->download(std::as_writable_bytes(std::span(&indices, 1)),
                                    list.command * kDrawCommandBytes);
            counts[view] += indices / 3;
        }
    }
    return counts;
}

double Renderer::lastDrawMs() const {
    return passes_->clock.lastMs();
}

std::span<const gl::PassTime> Renderer::lastPassTimes() const {
    return passes_->clock.lastPasses();
}

}  // namespace demolish::engine
