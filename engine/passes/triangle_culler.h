// Leaves out, before drawing, the triangles that no sample of a view would show.
#pragma once
#include <array>
#include <filesystem>

#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"
#include "engine/render/render_targets.h"

namespace demolish::engine {

/// As kViews of shaders/common/cull.glsl.
enum class CulledView : uint32_t { kCamera, kNearShadow, kFarShadow, kCount };

class TriangleCuller {
  public:
    explicit TriangleCuller(const std::filesystem::path& shaders);

    /// Are the mesh's lists short enough that three copies of them may take memory?
    static bool suits(const FractureMesh& mesh);
    /// For the frame whose uniforms are bound, drawn into `targets` and a shadow map of `shadow_texels` along
    /// a region's sides. What is kept keeps its order.
    void run(const FractureMesh& mesh, const RenderTargets& targets, int shadow_texels);
    /// Of the last run(); valid until the next.
    BodyTriangles triangles(CulledView view) const;

  private:
    /// What a list of triangles leaves behind.
    struct Culled {
        gl::Buffer seen_bits, block_counts, indices, commands;
        uint32_t block_room = 0;
    };
    enum Place { kExterior, kInterior, kLists };

    void makeRoom(Culled& culled, size_t indices) const;
    void bind(Place list) const;
    void dispatch(gl::Program& program, uint32_t groups);
    TriangleList listOf(Place list, CulledView view) const;

    gl::Program test_, scan_, write_;
    std::array<Culled, kLists> culled_;
    const FractureMesh* mesh_ = nullptr;
};

}  // namespace demolish::engine
