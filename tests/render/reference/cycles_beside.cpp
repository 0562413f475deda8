// SPDX-License-Identifier: Apache-2.0
// cycles_beside SCENE --at S --out DIR [--path-samples N] and the options of a shot: our frame beside the
// path tracer's, in DIR/beside.png. Exit code 77 without Blender.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "engine/image/contact_sheet.h"
#include "engine/image/png.h"
#include "tests/render/reference/reference_shot.h"

namespace {

constexpr int kWithoutBlender = 77;

}  // namespace

int main(int argc, char** argv) {
    using namespace demolish;
    CLI::App app("A frame of ours beside Blender's Cycles");
    ShotOptions options;
    double at = 0;
    int samples = 64;
    std::string out;
    addShotOptions(app, options);
    app.add_option("--at", at, "Moment, s")->required();
    app.add_option("--out", out, "Folder")->required();
    app.add_option("--path-samples", samples, "Samples a pixel of the path tracer");
    CLI11_PARSE(app, argc, argv);
    if (!reference::hasBlender()) {
        std::puts("blender is not installed");
        return kWithoutBlender;
    }
    try {
        const reference::ReferenceShot shot =
            reference::takeShot(options, at, pictureSize(options, {960, 540}));
        reference::writeShot(shot, out);
        const engine::Image pictures[] = {shot.ours, reference::pathTraced(out, samples)};
        engine::writePng(std::filesystem::path(out) / "beside.png",
                         engine::contactSheet(pictures, 2, shot.ours.width));
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        return 1;
    }
    return 0;
}
