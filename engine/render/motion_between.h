// SPDX-License-Identifier: Apache-2.0
// Shows a body, and the grit and dust about it, between two frames of its simulation, which goes on
// unchanged.
#pragma once
#include <array>
#include <filesystem>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/render/fracture_mesh.h"

namespace demolish::engine {

class MotionBetween {
  public:
    explicit MotionBetween(const std::filesystem::path& shader_folder);
    /// Keeps where all is: call before the next frame is brought to the mesh.
    void remember(const FractureMesh& mesh);
    /// Moves fragments, grains and puffs to where they were at this share of the way from the remembered
    /// frame (0) to the present one (1), `frame_s` seconds later. What is new stays where it is, but for
    /// sparks, which fly from where they were struck. Nothing moves before a first remember(). The particle
    /// view's spheres stay.
    void place(FractureMesh& mesh, float share, float frame_s);
    /// Brings the present frame back. Without place() it does nothing.
    void restore(FractureMesh& mesh);

  private:
    struct Kept {
        gl::Buffer before, after;
    };
    void placeFragments(FractureMesh& mesh, float share);
    void keepEffects(const FractureMesh& mesh);
    void placeEffects(FractureMesh& mesh, float share, float frame_s);
    gl::Program fragments_, effects_;
    gl::Buffer fragment_before_;
    Kept transforms_;
    std::array<Kept, 2> flying_;                       ///< grains and puffs
    bool had_effects_ = false, with_effects_ = false;  ///< at the remembered and at the present frame
    size_t remembered_ = 0;                            ///< particles
    bool moved_ = false;
};

}  // namespace demolish::engine
