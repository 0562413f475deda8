// SPDX-License-Identifier: Apache-2.0
// bullet_bench SCENE [options of `demolish bench`]: the scene's bodies in preset pieces, as --method pattern
// cuts them, moved by Bullet: a row for the table of `demolish bench SCENE --methods`, or pictures of
// moments.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "app/commands/bench_run.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"
#include "tests/bullet/bullet_pictures.h"
#include "tests/bullet/bullet_run.h"

namespace {

using namespace demolish;

constexpr PictureSize kDefaultSize{1920, 1080};

struct Arguments {
    ShotOptions shot;
    std::string json, pictures;
    std::vector<double> moments;  ///< s, ascending
    bool no_draw = false;
};

void addOptions(CLI::App& app, Arguments& arguments) {
    addShotOptions(app, arguments.shot);
    app.add_option("--json", arguments.json, "Report for programs, as of bench --methods")->type_name("FILE");
    app.add_flag("--no-draw", arguments.no_draw, "Simulate only; needs no OpenGL");
    auto* pictures = app.add_option("--pictures", arguments.pictures, "Draw moments into a folder instead");
    pictures->type_name("FOLDER");
    app.add_option("--at", arguments.moments, "Moments of the pictures, s, ascending, with commas")
        ->delimiter(',')
        ->needs(pictures);
}

Shot shotOf(ShotOptions options) {
    if (!options.method.empty() && options.method != methodName(Method::kPattern))
        throw UsageError("pieces are cut by method pattern; leave out --method");
    options.method = methodName(Method::kPattern);
    if (options.effects.empty()) options.effects = "off";
    return makeShot(options, "paper");
}

void drawMoments(const Arguments& arguments, const Shot& shot) {
    HeadlessStage stage(choosesCuda(shot));
    const uint64_t frames = framesOfShot(shot);
    const bullet::CutScene cut = bullet::cutScene(buildShot(shot, {}, {}), frames, true);
    const PictureSize size = pictureSize(arguments.shot, kDefaultSize);
    bullet::Pictures pictures(*cut.session, stage, arguments.pictures, size.width, size.height,
                              arguments.moments.size());
    size_t drawn = 0;
    bullet::runInBullet(cut.session->built(), cut.pieces, frames,
                        [&](const bullet::World& world, double time) {
                            if (drawn == arguments.moments.size()) return;
                            if (time < arguments.moments[drawn] - 0.5 / shot.fps) return;
                            pictures.draw(world, cut.pieces);
                            ++drawn;
                        });
    pictures.finish();
}

void measure(const Arguments& arguments, const Shot& shot) {
    const PictureSize size = arguments.no_draw ? PictureSize{} : pictureSize(arguments.shot, kDefaultSize);
    MethodsPlace place{shot.scene, "nobody", 0, 0, framesOfShot(shot)};
    const MethodRow rows[] = {bullet::bulletRow(shot, arguments.shot, size, place)};
    LastFiles files;
    files.write(arguments.json, [&] { return methodsJson(rows, place); });
    std::fputs(methodsTable(rows, place).c_str(), stdout);
    files.requireAllWritten();
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Preset pieces of a scene as convex hulls in Bullet");
    Arguments arguments;
    addOptions(app, arguments);
    CLI11_PARSE(app, argc, argv);
    const Shot shot = shotOf(arguments.shot);
    arguments.pictures.empty() ? measure(arguments, shot) : drawMoments(arguments, shot);
    return 0;
} catch (const UsageError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
