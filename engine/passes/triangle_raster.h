// SPDX-License-Identifier: Apache-2.0
// Finds in compute passes which samples the triangles of a mesh cover: small ones by a lane each, large ones
// square by square. What becomes of a covered sample is the including shader's (shaders/common/raster.glsl).
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/passes/body_geometry.h"

namespace demolish::engine {

class TriangleRaster {
  public:
    struct Programs {
        gl::Program triangles, setup, squares, large;
    };

    /// `task_room`: squares of 16 px of large triangles, 52 bytes each; where they do not suffice it goes
    /// slower.
    TriangleRaster(std::filesystem::path shaders, size_t task_room);

    /// `places`: of a pixel's samples, 0..1. Throws GlError.
    Programs make(const std::string& defines, std::span<const glm::vec2> places) const;
    /// What make() tells its programs, for another one that includes raster.glsl.
    void tell(gl::Program& program, std::span<const glm::vec2> places) const;

    /// Room for triangles that were found, and for as many `pixels` that are lit later.
    void makeRoom(const FractureMesh& mesh, size_t pixels);
    static size_t foundBytes(const FractureMesh& mesh, size_t pixels);
    /// Binds the mesh and what is found; `near` as in BodyGeometry.
    void bind(const FractureMesh& mesh, const NearFaces* near = nullptr) const;
    /// Forgets what was found; fills `fours` times four words of what is bound as kVisible with zeros, and
    /// the shadow map with the farthest depths unless `shadow_texels` is 0.
    void clear(size_t fours, int shadow_texels);
    /// Does a driver need a second round for names, since it cannot take the nearest of depth and name in
    /// one?
    static bool namesLater();
    /// Goes before the text of whatever puts samples (shaders/common/put_visible.glsl, put_face.glsl).
    static std::string defines();
    /// First those that a lane does, then the others. `naming`: the second round, once all depths are known.
    static void runSmall(Programs& programs, bool naming);
    static void runLarge(Programs& programs, bool naming);
    static void setNaming(gl::Program& program, bool naming);

  private:
    std::filesystem::path shaders_;
    size_t task_room_;
    gl::Program clear_;
    gl::Buffer found_, tasks_, large_;
    NearFaces no_near_;
};

}  // namespace demolish::engine
