// SPDX-License-Identifier: Apache-2.0
// Pieces where Bullet has them, drawn as ours are.
#pragma once
#include <filesystem>
#include <span>
#include <vector>

#include "app/commands/frame_files.h"
#include "app/commands/headless_stage.h"
#include "app/session/session.h"
#include "tests/bullet/bullet_world.h"

namespace demolish::bullet {

/// Puts the pieces of a session that has cut the bodies and draws where Bullet has them.
void placePieces(Session& session, const World& world, std::span<const Piece> pieces);
std::vector<engine::SphereDraw> ballsOf(const World& world);

class Pictures {
  public:
    /// Of a session that has cut the bodies and draws; `frames` pictures in all. Throws OutputError.
    Pictures(Session& session, HeadlessStage& stage, const std::filesystem::path& folder, int width,
             int height, uint64_t frames);

    void draw(const World& world, std::span<const Piece> pieces);
    void finish();

  private:
    Session& session_;
    HeadlessStage& stage_;
    FrameFiles files_;
    engine::FrameView view_;
    engine::FrameCapture target_;
    uint64_t drawn_ = 0;
};

}  // namespace demolish::bullet
