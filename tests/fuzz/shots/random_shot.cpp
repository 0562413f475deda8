// SPDX-License-Identifier: Apache-2.0
// Options drawn one after the other; then as many frames, and no more particles, than the cost allows.
#include "tests/fuzz/shots/random_shot.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "app/session/data_folder.h"
#include "app/session/output_file.h"
#include "app/session/scene_file.h"
#include "app/session/shot_geometry.h"
#include "app/session/shot_setup.h"
#include "app/session/step_division.h"
#include "tests/fuzz/shots/fuzz_models.h"
#include "tests/fuzz/shots/random_set.h"
#include "tests/fuzz/support/dice.h"
#include "tests/physics/scenes/scene_run.h"

namespace demolish::fuzz {
namespace {

constexpr uint64_t kMostFrames = 120, kLeastFrames = 3;
constexpr double kKappa = 0.68, kStepSafety = 0.5;  // of the usual body: the cost is an estimate

/// Digits that the command line gives back to the last bit.
std::string exactly(double value) {
    std::array<char, 40> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// The value that four digits of it say, so that commands are short.
double rounded(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return std::strtod(text.data(), nullptr);
}

double logNumber(Dice& dice, double from, double to) {
    return rounded(dice.logUniform(from, to));
}

double wholeNumber(Dice& dice, double from, double to) {
    return std::round(dice.logUniform(from, to));
}

void chooseImpact(Dice& dice, ShotOptions& options) {
    const double kind = dice.uniform(0, 1);
    if (kind < 0.35)
        options.drop = logNumber(dice, 0.1, 60);
    else if (kind < 0.8)
        options.impact_velocity = logNumber(dice, 0.5, 200);
    else if (kind < 0.85)
        options.impact_velocity = 0;
    if (dice.chance(0.15)) options.break_at = logNumber(dice, 0.5, 50);
}

void chooseTime(Dice& dice, ShotOptions& options) {
    static constexpr std::array<double, 9> kUsualFps = {5, 10, 24, 25, 30, 50, 60, 120, 240};
    if (dice.chance(0.5)) options.fps = dice.chance(0.7) ? dice.pick(kUsualFps) : logNumber(dice, 2, 1000);
    if (dice.chance(0.2)) options.slow_motion = logNumber(dice, 0.01, 1);
    if (dice.chance(0.25)) options.substeps = wholeNumber(dice, 1, 600);
}

void chooseSolver(Dice& dice, ShotOptions& options) {
    static constexpr std::array<double, 7> kPieces = {0, 1, 2, 5, 40, 200, 5000};
    if (dice.chance(0.3)) options.pieces = dice.pick(kPieces);
    if (dice.chance(0.5)) options.seed = static_cast<double>(dice.below(10000));
    options.no_hand_over = dice.chance(0.25);
    options.no_sleep = dice.chance(0.25);
}

void chooseBody(Dice& dice, const Subject& subject, const std::filesystem::path& models,
                ShotOptions& options) {
    if (subject.is_scene)
        options.scene = subject.name;
    else
        options.model = modelFile(subject.name, models).string();
    if (dice.chance(0.5)) options.height = logNumber(dice, 0.05, 20);
    if (dice.chance(0.05)) options.height = dice.chance(0.5) ? 0.01 : 100;
    if (dice.chance(0.6)) options.material = dice.pick(assetNames("materials"));
    chooseSolver(dice, options);
}

/// Its bodies have materials and heights of their own, and it says what hits them.
Subject chooseSet(Dice& dice, const std::string& name, const std::filesystem::path& models,
                  ShotOptions& options) {
    const RandomSet set = randomSet(dice, models);
    const std::filesystem::path file = models / (name + ".toml");
    writeTextFile(file, set.text);
    options.scene = file.string();
    if (dice.chance(0.1)) options.drop = logNumber(dice, 0.1, 20);
    chooseSolver(dice, options);
    return {options.scene, true, set.smallest_volume};
}

/// Of all bodies together, and what they cost.
struct Size {
    double bodies = 1, volume = 1, height = 1, particles = 1;
    double ofEach() const { return std::max(2.0, std::floor(particles / bodies)); }
    double spacing() const { return std::cbrt(volume / ofEach()); }
};

/// Per 1/60 s.
double expectedSubsteps(const Shot& shot, const Size& size) {
    if (shot.substeps) return *shot.substeps;
    Shot broken = shot;
    if (shot.break_at) broken.material.critical_velocity = 2 * *shot.break_at;
    const double speed = wantedWaveSpeed(broken, size.height);
    return std::clamp(speed / (kKappa * kStepSafety * 60 * size.spacing()), 40.0, kSubstepRange.most);
}

/// Times what a shot may cost, with all divided substeps: a cell of a quarter of a millimetre that a ball of
/// 64 m/s hits has its substeps divided by 925, and that shot would have taken an hour.
constexpr double kMostDivided = 20;

/// Steps into which each of them is divided where something would come far in one (step_division.h). Up to
/// kMostDivided no part of what a shot may cost, by which it is chosen: seeds go on meaning the same shots.
double expectedDivision(const Shot& shot, const Size& size) {
    const double fall = 4 * kGravity * size.height, shot_speed = shot.impact.velocity,
                 way = std::sqrt(shot_speed * shot_speed + fall) / (60 * expectedSubsteps(shot, size));
    return std::max(1.0, way / std::min(kFarthestStep * size.spacing(), kFarthestBall * size.height / 12));
}

struct Cost {
    double frame = 0, start = 0;  ///< particles x substeps
};

Cost expectedCost(const Shot& shot, const Size& size) {
    const double work = size.ofEach() * size.bodies * expectedSubsteps(shot, size);
    const bool dropped = shot.impact.kind == ImpactKind::kDrop;
    return {work * std::max(1.0, 60 / shot.fps * shot.time_scale),
            dropped ? 0 : 60 * shot.settle_time * work};
}

/// Fewer particles until some frames are affordable; then as many frames as are.
void fitCost(Dice& dice, const RandomShotLimits& limits, const Subject& subject, RandomShot& random) {
    ShotOptions& options = random.options;
    const Shot shot = random.shot();
    Size size;
    size.bodies = static_cast<double>(std::max<size_t>(1, shot.bodies.size()));
    size.height = shot.height;
    const double scale = subject.is_scene ? shot.height / loadScene(subject.name).height : shot.height;
    size.volume = subject.volume * std::pow(scale, 3);
    size.particles = std::max(2 * size.bodies, wholeNumber(dice, 2, limits.most_particles));
    const auto cost = [&] { return expectedCost(random.shot(), size); };
    const auto allowed = [&] {
        return limits.cost * std::min(1.0, kMostDivided / expectedDivision(random.shot(), size));
    };
    const auto affordable = [&] {
        return cost().start + static_cast<double>(kLeastFrames) * cost().frame <= allowed();
    };
    while (!affordable() && size.ofEach() > 2) size.particles /= 2;
    while (!affordable() && random.shot().fps < 500) options.fps = 2 * random.shot().fps;
    const double spacing = rounded(size.spacing());
    // A size out of range would ask for other particles than the cost was reckoned for; so would one for
    // bodies of many sizes.
    if (!limits.sets && dice.chance(0.25) && spacing >= kParticleSizeRange.least &&
        spacing <= kParticleSizeRange.most)
        options.particle_size = spacing;
    else
        options.particles = size.ofEach();
    const double frames = (allowed() - cost().start) / cost().frame;
    random.frames = static_cast<uint64_t>(std::clamp(frames, double{kLeastFrames}, double{kMostFrames}));
    random.cost = expectedDivision(random.shot(), size) *
                  (cost().start + static_cast<double>(random.frames) * cost().frame);
}

void chooseByHand(Dice& dice, RandomShot& random) {
    if (random.options.impact_velocity == 0.0 || !dice.chance(0.25)) return;
    const size_t shots = 1 + dice.below(3);
    for (size_t k = 0; k < shots; ++k)
        random.by_hand.push_back(
            {dice.below(random.frames),
             {dice.uniform(-1, 1), dice.uniform(0.1, 1), dice.uniform(-1, 1)},
             {dice.uniform(-0.3, 0.3), dice.uniform(-0.3, 0.3), dice.uniform(-0.3, 0.3)}});
}

Watching chooseWatching(Dice& dice, bool may_record) {
    Watching watching;
    watching.threads = 2;
    watching.every = static_cast<uint32_t>(wholeNumber(dice, 1, 8));
    watching.ledger = dice.chance(0.8);
    watching.measure = dice.chance(0.5);
    watching.draw_geometry = dice.chance(0.5);
    watching.frames = dice.chance(0.6);
    watching.restore = dice.chance(0.3);
    watching.record = dice.chance(0.5) && may_record;
    if (watching.record) watching.draw_geometry = true;
    return watching;
}

/// And what happens to it.
Subject chooseSubject(Dice& dice, const std::string& name, bool sets, const std::filesystem::path& models,
                      ShotOptions& options) {
    if (sets) return chooseSet(dice, name, models, options);
    const Subject& subject =
        dice.chance(0.4) ? subjects()[dice.below(5)] : subjects()[5 + dice.below(subjects().size() - 5)];
    chooseBody(dice, subject, models, options);
    chooseImpact(dice, options);
    return subject;
}

}  // namespace

std::string Watching::inWords() const {
    std::string words = std::to_string(threads) + " threads";
    const auto add = [&words](bool on, const char* name) {
        if (on) words += std::string(", ") + name;
    };
    add(ledger, "ledger");
    add(measure, "measured");
    add(draw_geometry, "draw geometry");
    add(frames, "exported");
    add(record, "recorded");
    add(restore, "saved and restored");
    return words + "; every " + std::to_string(every) + " frames";
}

Shot RandomShot::shot() const {
    Shot made = makeShot(options, "paper");
    if (first_impact) tests::bringForward(made, {*first_impact, 3 * *first_impact});
    return made;
}

std::vector<std::string> RandomShot::benchWords() const {
    std::vector<std::string> words = {"bench"};
    if (!options.scene.empty()) words.push_back(options.scene);
    const auto add = [&words](const char* option, const std::string& value) {
        if (value.empty()) return;
        words.emplace_back(option);
        words.push_back(value);
    };
    const auto number = [&](const char* option, const std::optional<double>& value) {
        if (value) add(option, exactly(*value));
    };
    add("--model", options.model);
    add("--device", options.device);
    add("--material", options.material);
    number("--height", options.height);
    number("--drop", options.drop);
    number("--impact-velocity", options.impact_velocity);
    number("--break-at", options.break_at);
    number("--particle-size", options.particle_size);
    number("--particles", options.particles);
    number("--pieces", options.pieces);
    number("--fps", options.fps);
    number("--slow-motion", options.slow_motion);
    number("--substeps", options.substeps);
    number("--seed", options.seed);
    if (options.no_hand_over) words.emplace_back("--no-hand-over");
    if (options.no_sleep) words.emplace_back("--no-sleep");
    for (const char* word : {"--no-draw", "--warmup", "0", "--frames"}) words.emplace_back(word);
    words.push_back(std::to_string(frames));
    return words;
}

RandomShot randomShot(uint64_t seed, uint64_t index, const RandomShotLimits& limits,
                      const std::filesystem::path& models) {
    Dice dice(seed, index);
    RandomShot random;
    random.options.device = limits.device;
    const Subject subject = chooseSubject(dice, "set_" + std::to_string(seed) + "_" + std::to_string(index),
                                          limits.sets, models, random.options);
    chooseTime(dice, random.options);
    if (dice.chance(0.5)) random.first_impact = rounded(dice.uniform(0.01, 0.06));
    fitCost(dice, limits, subject, random);
    chooseByHand(dice, random);
    random.watching = chooseWatching(dice, limits.may_record);
    return random;
}

}  // namespace demolish::fuzz
