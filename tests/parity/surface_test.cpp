// SPDX-License-Identifier: Apache-2.0
// What is drawn of a broken body has the same bits on CPU and GPU: faces of breaks with their waves, the
// outside along the cracks, and the lines of cracks.
#include <algorithm>
#include <cstring>

#include "app/bridge/host_frame.h"
#include "tests/parity/on_the_gpu.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::tests {
namespace {

class DrawnSurface : public OnTheGpu {};

struct Drawn {
    std::vector<SurfaceVertex> inner, outer;
    std::vector<CrackLine> lines;
};
/// Slots of the pool that no triangle uses hold whatever they held.
Drawn drawnOf(Solver& solver) {
    HostFrame frame = readFrame(solver);
    Drawn drawn;
    const auto inner = std::span(frame.interior_indices).first(frame.commands.interior.count);
    for (const uint32_t index : inner) drawn.inner.push_back(frame.interior_vertices[index]);
    drawn.outer = std::move(frame.exterior_vertices);
    frame.crack_edges.resize(frame.commands.cracks.instance_count);
    drawn.lines = std::move(frame.crack_edges);
    return drawn;
}
template <class T>
bool haveTheSameBits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

Session sessionOf(const std::string& scene, float waves, DeviceChoice device) {
    Shot shot = smallScene(scene, 1500);
    shot.material.break_waves = waves;
    shot.device = device;
    bringForward(shot, {});
    return Session(buildShot(shot, {}, {}), {.draw = false});
}

TEST_F(DrawnSurface, HasTheSameBitsOnBothDevicesWhileABodyBreaks) {
    for (const auto& [scene, waves] : {std::pair{"bunny", 0.5f}, {"wolf", 0.5f}, {"bunny", 0.0f}}) {
        Session cpu = sessionOf(scene, waves, DeviceChoice::kCpu),
                gpu = sessionOf(scene, waves, DeviceChoice::kCuda);
        size_t most_inner = 0, most_lines = 0;
        for (int frame = 0; frame < 40; ++frame) {
            ASSERT_EQ(cpu.advance(), StepStatus::kOk);
            ASSERT_EQ(gpu.advance(), StepStatus::kOk);
            if (frame % 8 != 7) continue;
            const Drawn on_cpu = drawnOf(cpu.solver()), on_gpu = drawnOf(gpu.solver());
            EXPECT_TRUE(haveTheSameBits(on_cpu.inner, on_gpu.inner)) << scene << ", frame " << frame;
            EXPECT_TRUE(haveTheSameBits(on_cpu.outer, on_gpu.outer)) << scene << ", frame " << frame;
            EXPECT_TRUE(haveTheSameBits(on_cpu.lines, on_gpu.lines)) << scene << ", frame " << frame;
            most_inner = std::max(most_inner, on_cpu.inner.size());
            most_lines = std::max(most_lines, on_cpu.lines.size());
        }
        EXPECT_GT(most_inner, 1000u) << scene;
        EXPECT_GT(most_lines, 20u) << scene;
    }
}

}  // namespace
}  // namespace demolish::tests
