// SPDX-License-Identifier: Apache-2.0
// Fragments come from the solver; what they look like, from a surface of the test's own.
#include "tests/unit/cracks/broken_shot.h"

#include <stdexcept>

#include "app/bridge/host_frame.h"

namespace demolish::test {

std::unique_ptr<DrawnSurface> drawnShot(const Shot& shot, double seconds) {
    Session session(buildShot(shot, {}, {}), SessionOptions{.draw = false});
    auto drawn = std::make_unique<DrawnSurface>(session.built().setup);
    const size_t particles = drawn->cells();
    uint32_t broken = 0;
    drawn->show(std::vector<uint32_t>(particles, 0));
    while (session.solver().stats().time < seconds) {
        if (session.advance() != StepStatus::kOk) throw std::runtime_error("a step failed");
        const FrameStats& stats = session.solver().stats();
        if (stats.bonds_broken == broken) continue;
        broken = stats.bonds_broken;
        std::vector<uint32_t> fragment =
            readFrame(session.solver(), FrameParts::kFragments).particle_fragment;
        fragment.resize(particles);  // without projectiles
        drawn->show(fragment);
    }
    return drawn;
}

}  // namespace demolish::test
