// SPDX-License-Identifier: Apache-2.0
// crack_table SCENE PARTICLES SECONDS [conform]: the first body of the scene, hit at 0.1 s; a row of
// Markdown.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

#include "app/session/scene_file.h"
#include "tests/unit/cracks/broken_shot.h"
#include "tests/unit/cracks/crack_measures.h"

namespace {

void printRow(const char* scene, uint32_t particles, double seconds, bool conform) {
    using namespace demolish;
    Shot shot = loadScene(scene);
    if (shot.bodies.size() > 1) shot = tests::smallScene(scene, particles, {17});
    shot.device = DeviceChoice::kCpu;
    shot.fineness.particles = particles;
    shot.conform = conform;
    tests::bringForward(shot, {});
    const auto drawn = test::drawnShot(shot, seconds);
    const test::CrackMeasures m = test::measureCracks(*drawn, drawn->spacing(), drawn->volume());
    std::printf(
        "| %s %u%s | %zu, %zu | %.3f / %.2f | %.3f, %.3f / %.2f (%.0f h) | %.3f (%.0f h²) | %zu of %zu, %.1e "
        "| %zu "
        "| "
        "%.1e |\n",
        scene, particles, conform ? " conform" : "", m.pieces, m.large_pieces, m.outline_at_rest.deviation,
        m.outline_at_rest.turning, m.outline.deviation, m.outline.sideways, m.outline.turning,
        m.outline.length, m.faces, m.face_area, m.flipped, m.parts, m.flipped_area, m.open_edges,
        m.volume_error);
}

}  // namespace

int main(int argc, char** argv) try {
    const bool conform = argc == 5 && std::strcmp(argv[4], "conform") == 0;
    if (argc != 4 && !conform) {
        std::fputs("usage: crack_table SCENE PARTICLES SECONDS [conform]\n", stderr);
        return 2;
    }
    printRow(argv[1], static_cast<uint32_t>(std::strtoul(argv[2], nullptr, 10)),
             std::strtod(argv[3], nullptr), conform);
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
