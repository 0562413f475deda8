// SPDX-License-Identifier: Apache-2.0
// What the window shows: at once while something moves; a still gets finer each time that it is shown again.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "engine/render/film.h"
#include "engine/render/renderer.h"
#include "engine/scene/lens.h"

namespace demolish {

class StillPicture {
  public:
    explicit StillPicture(engine::Renderer& renderer) : renderer_(renderer) {}
    /// `moves`: the simulation goes on. The lens shows in stills alone.
    void draw(const engine::FractureMesh* mesh, std::span<const engine::SphereDraw> spheres,
              const engine::FrameView& view, const engine::Lens& lens, bool moves, unsigned framebuffer);

  private:
    bool isAsBefore(uint64_t version, std::span<const engine::SphereDraw> spheres,
                    const engine::FrameView& view, const engine::Lens& lens) const;
    engine::Renderer& renderer_;
    std::unique_ptr<engine::Film> film_;  ///< made for the first still
    engine::FrameView view_;              ///< of the last call, as all below
    engine::Lens lens_;
    std::vector<engine::SphereDraw> spheres_;
    uint64_t version_ = 0;
    bool is_exposed_ = false;
};

}  // namespace demolish
