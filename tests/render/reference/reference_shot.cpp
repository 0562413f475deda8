// SPDX-License-Identifier: Apache-2.0
// Through the program's own ways: options, session, headless renderer.
#include "tests/render/reference/reference_shot.h"

#include <cmath>
#include <stdexcept>

#include "app/commands/headless_stage.h"
#include "app/session/picture.h"
#include "app/session/session.h"
#include "engine/render/frame_capture.h"
#include "sim_cuda/api/stats.h"

namespace demolish::reference {

ReferenceShot takeShot(const ShotOptions& options, double at, PictureSize size) {
    ShotOptions plain = options;
    plain.device = "cpu";
    plain.effects = "off";
    BuiltShot built = buildShot(makeShot(plain), {.ledger = false}, {});
    HeadlessStage stage(false);
    Session session(std::move(built), {.draw = true});
    const auto frames = std::lround(at * session.shot().fps / session.shot().time_scale);
    for (long frame = 0; frame < frames; ++frame)
        if (const StepStatus status = session.advance(); status != StepStatus::kOk)
            throw std::runtime_error(describe(status));
    ReferenceShot shot;
    shot.view = makeFrameView(session.built().shot, session.built().cells.of_body, size.width, size.height,
                              engine::RenderQuality::kFull);
    shot.view.lighting.tone = engine::ToneCurve::kNone;
    shot.view.show_cracks = false;
    engine::FrameCapture target(size.width, size.height,
                                [&](uint64_t, engine::Image image) { shot.ours = std::move(image); });
    stage.renderer().draw(session.mesh(), session.spheres(), shot.view, target.framebuffer());
    target.submit(0);
    target.finish();
    shot.frame = readFrame(session.solver());
    return shot;
}

}  // namespace demolish::reference
