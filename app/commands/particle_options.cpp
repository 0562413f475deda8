// SPDX-License-Identifier: Apache-2.0
#include "app/commands/particle_options.h"

#include <CLI/CLI.hpp>

#include "app/commands/option_values.h"
#include "app/session/paint_names.h"
#include "sim_cuda/api/authoring.h"

namespace demolish {
namespace {

constexpr Range kSeedRange{0, 4294967295.0};  // as in scene files; packings take 32 bits of it

void applyPainted(const ShotOptions& options, Shot& shot) {
    if (const auto channel = paintChannelOf(options.painted)) {
        if (!shot.painted) shot.painted.emplace();
        shot.painted->channel = *channel;
    }
    if (!options.painted_least) return;
    if (!shot.painted) throw UsageError("--painted-least is for --painted, which is not given");
    shot.painted->least = inRange("--painted-least", *options.painted_least, kPaintedLeastRange, "");
}

}  // namespace

void addParticleOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("--pieces", options.pieces, "Tough cells of each body: how many pieces it is made of")
        ->type_name("N");
    command
        .add_option("--particle-size", options.particle_size,
                    "Mean spacing of the particles, instead of their number")
        ->type_name("M");
    command
        .add_option("--conform", options.conform,
                    "Cells follow the borders of tough cells: even cracks, another packing")
        ->type_name("on|off")
        ->check(CLI::IsMember({"on", "off"}).description(""));
    command
        .add_option("--refine", options.refine,
                    "Finer particles where the shot is aimed: spacing far from there over that there, 1..4")
        ->type_name("FACTOR");
    command
        .add_option("--particles", options.particles,
                    "Particles of each body, 2 to 4,000,000 (default: the scene's)")
        ->type_name("N");
    command
        .add_option("--painted", options.painted,
                    "Where this channel of the colours at the model's vertices is dark, bonds are weak")
        ->type_name("red|green|blue|alpha")
        ->check(CLI::IsMember(paintChannelNames()).description(""));
    command
        .add_option("--painted-least", options.painted_least,
                    "Of --painted: times the strength where the channel is black, 0.01..1 (0.1)")
        ->type_name("FACTOR");
    command
        .add_option("--substeps", options.substeps, "Substeps per 1/60 s (default: from the particle size)")
        ->type_name("N");
    command.add_option("--seed", options.seed, "Seed of packing and strengths (default: the scene's)")
        ->type_name("N");
}

void applyParticles(const ShotOptions& options, Shot& shot) {
    if (options.particle_size && options.particles)
        throw UsageError("--particle-size and --particles exclude each other: one follows from the other");
    if (options.particle_size)
        shot.fineness.particle_size =
            inRange("--particle-size", *options.particle_size, kParticleSizeRange, "m");
    if (options.particles)
        shot.fineness.particles = static_cast<uint32_t>(
            wholeNumber("--particles", *options.particles, {kMinParticles, kMaxParticles}));
    if (options.refine) shot.refine = inRange("--refine", *options.refine, kRefineRange, "");
    if (!options.conform.empty()) shot.conform = options.conform == "on";
    applyPainted(options, shot);
    if (options.quality == "draft") shot.fineness.full = shot.fineness.draft;
    if (options.quality == "full") shot.fineness.draft = shot.fineness.full;
    if (options.substeps)
        shot.substeps = static_cast<uint32_t>(wholeNumber("--substeps", *options.substeps, kSubstepRange));
    if (options.seed) shot.seed = static_cast<uint64_t>(wholeNumber("--seed", *options.seed, kSeedRange));
}

}  // namespace demolish
