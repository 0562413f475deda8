// SPDX-License-Identifier: Apache-2.0
// Towers and rows of bodies first, then what happens to them.
#include "tests/fuzz/shots/random_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

#include "app/session/data_folder.h"
#include "sim_cuda/api/vectors.h"
#include "tests/fuzz/shots/fuzz_models.h"

namespace demolish::fuzz {
namespace {

/// A model that something can stand on, or that can stand; sizes over what `height_m` scales, which is the
/// longest side of a plate.
struct Part {
    const char* model;
    double width, height, depth;
    bool is_flat;  ///< above and below
};
constexpr std::array<Part, 8> kParts = {{{"cube", 1, 1, 1, true},
                                         {"cube", 1, 1, 1, true},
                                         {"plate", 1, 0.02, 1, true},
                                         {"wall", 2, 1, 0.03, true},
                                         {"needle", 0.02, 1, 0.02, true},
                                         {"egg", 0.54, 1, 0.54, false},
                                         {"sphere", 1, 1, 1, false},
                                         {"torus", 3.5, 1, 3.5, false}}};
constexpr std::array<double, 5> kGaps = {0, 0, 1e-4, 1e-3, -5e-4};  ///< m

struct Placed {
    Part part = kParts[0];
    double size = 0;  ///< m, `height_m`
    Double3 foot;
    double yaw = 0;  ///< degrees

    double height() const { return size * part.height; }
    double top() const { return foot.y + height(); }
};

double volumeOf(const Placed& body) {
    const auto& all = subjects();
    const auto found =
        std::find_if(all.begin(), all.end(), [&](const Subject& s) { return s.name == body.part.model; });
    return found->volume * std::pow(body.height(), 3);
}

/// m, so that no part is wider than the others by much.
double sizeOf(Dice& dice, const Part& part) {
    return dice.logUniform(0.1, 0.6) / std::max(1.0, 0.5 * part.width);
}

void addTower(Dice& dice, double x, std::vector<Placed>& bodies) {
    const size_t floors = 1 + dice.below(4);
    double y = 0;
    for (size_t k = 0; k < floors; ++k) {
        Placed body;
        body.part = dice.pick(kParts);
        body.size = sizeOf(dice, body.part);
        const double off = 0.2 * body.size * std::min(1.0, body.part.width);
        body.foot = {x + dice.uniform(-off, off), y, dice.uniform(-off, off)};
        body.yaw = dice.chance(0.5) ? 0 : dice.uniform(0, 90);
        bodies.push_back(body);
        if (!body.part.is_flat) return;
        y = std::max(0.0, body.top() + dice.pick(kGaps));
    }
}

/// Cubes that touch with their sides, some courses high.
void addRow(Dice& dice, double x, std::vector<Placed>& bodies) {
    const double edge = dice.logUniform(0.1, 0.4), pitch = edge + dice.pick(kGaps);
    const size_t columns = 1 + dice.below(3), courses = 1 + dice.below(3);
    for (size_t row = 0; row < courses; ++row)
        for (size_t k = 0; k < columns; ++k)
            bodies.push_back({.part = kParts[0],
                              .size = edge,
                              .foot = {x + (static_cast<double>(k) + (row % 2 == 1 ? 0.5 : 0.0)) * pitch,
                                       static_cast<double>(row) * std::max(edge, pitch), 0}});
}

std::string inBrackets(const Double3& v) {
    std::ostringstream text;
    text.precision(6);
    text << "[" << v.x << ", " << v.y << ", " << v.z << "]";
    return text.str();
}

Double3 anyWay(Dice& dice, double length) {
    const double up = dice.uniform(-0.3, 0.6), turn = dice.uniform(0, 2 * std::numbers::pi);
    const double level = length * std::sqrt(1 - up * up);
    return {level * std::cos(turn), length * up, level * std::sin(turn)};
}

/// A box round the lowest fifth, which is no smaller than an anchor may be.
Double3 footOf(const Placed& body) {
    constexpr double kLeast = 1e-3;
    return {std::max(kLeast, 2 * body.size * body.part.width), std::max(kLeast, 0.4 * body.height()),
            std::max(kLeast, 2 * body.size * body.part.depth)};
}

/// What the body does beside standing where it is.
void writeConduct(Dice& dice, const Placed& body, bool may_move, std::ostream& out) {
    if (dice.chance(0.4)) out << ", material = \"" << dice.pick(assetNames("materials")) << '"';
    if (dice.chance(0.15)) out << ", mortar = false";
    const double kind = dice.uniform(0, 1);
    if (kind < 0.1)
        out << ", breaks = false";
    else if (kind < 0.2)
        out << ", anchor = [{ shape = \"box\", size_m = " << inBrackets(footOf(body))
            << ", position_m = [0, 0, 0] }]";
    else if (kind < 0.27)
        out << ", breaks = false, path = [{ at_s = 0.1 }, { at_s = 0.3, position_m = "
            << inBrackets(anyWay(dice, 0.3)) << ", rotation_deg = [0, 40, 0] }]";
    else if (may_move && kind < 0.6)
        out << ", velocity_mps = " << inBrackets(anyWay(dice, dice.logUniform(0.1, 50)))
            << ", spin_radps = " << inBrackets(anyWay(dice, dice.logUniform(0.1, 30)));
}

void writeBody(Dice& dice, const Placed& body, bool may_move, const std::filesystem::path& models,
               std::ostream& out) {
    out << "    { model = \"" << modelFile(body.part.model, models).string() << "\", height_m = " << body.size
        << ", position_m = " << inBrackets(body.foot);
    if (body.yaw != 0) out << ", yaw_deg = " << body.yaw;
    writeConduct(dice, body, may_move, out);
    out << " },\n";
}

void writeBalls(Dice& dice, size_t bodies, std::ostream& out) {
    out << "ball = [\n";
    const size_t balls = 1 + dice.below(3);
    for (size_t k = 0; k < balls; ++k) {
        Double3 way = anyWay(dice, 1);
        way.y = -std::abs(way.y);
        out << "    { at_s = " << 0.02 + 0.05 * static_cast<double>(k) << ", body = " << dice.below(bodies)
            << ", velocity_mps = " << dice.logUniform(0.5, 200)
            << ", radius_m = " << dice.logUniform(0.02, 0.12) << ", direction = " << inBrackets(way)
            << " },\n";
    }
    out << "]\n";
}

/// Beside the bodies, where pieces of them may come.
void writeCollider(Dice& dice, std::ostream& out) {
    const Double3 at{dice.uniform(-2, 2), dice.uniform(0, 0.5), dice.chance(0.5) ? 1.6 : -1.6};
    out << "\n[[collider]]\n";
    const size_t shape = dice.below(4);
    if (shape == 0)
        out << "shape = \"box\"\nsize_m = [1, 0.6, 0.8]\nrotation_deg = [0, 30, 20]\n";
    else if (shape == 1)
        out << "shape = \"sphere\"\nradius_m = 0.4\n";
    else if (shape == 2)
        out << "shape = \"plane\"\nnormal = [0, 0.5, " << (at.z > 0 ? -1 : 1) << "]\n";
    else
        out << "shape = \"capsule\"\nradius_m = 0.1\nfrom_m = [-1, 0.3, 1.2]\nto_m = [1, 0.5, 1.3]\n";
    if (shape != 3) out << "position_m = " << inBrackets(at) << '\n';
    if (dice.chance(0.5)) out << "friction = " << dice.uniform(0, 1.5) << '\n';
    if (dice.chance(0.5)) out << "restitution = " << dice.uniform(0.05, 1) << '\n';
}

}  // namespace

RandomSet randomSet(Dice& dice, const std::filesystem::path& models) {
    std::vector<Placed> bodies;
    const size_t groups = 1 + dice.below(2);
    for (size_t k = 0; k < groups; ++k)
        dice.chance(0.6) ? addTower(dice, 1.8 * static_cast<double>(k), bodies)
                         : addRow(dice, 1.8 * static_cast<double>(k), bodies);
    RandomSet set;
    set.smallest_volume = 1e300;
    std::ostringstream text;
    text.precision(6);
    const bool may_move = dice.chance(0.25);
    double top = 0;
    std::ostringstream list;
    list.precision(6);
    for (const Placed& body : bodies) {
        writeBody(dice, body, may_move, models, list);
        top = std::max(top, body.top());
        set.smallest_volume = std::min(set.smallest_volume, volumeOf(body));
    }
    text << "version = 1\ntitle = \"A random set\"\nheight_m = " << std::max(top, 0.01)
         << "\nmaterial_preset = \"" << dice.pick(assetNames("materials")) << "\"\nbody = [\n"
         << list.str() << "]\n";
    if (dice.chance(0.8)) writeBalls(dice, bodies.size(), text);
    text << "\n[particles]\nfull = 200\ndraft = 200\nseed = 1\n";
    text << "\n[solver]\nsettle_s = " << (may_move ? 0 : dice.uniform(0, 0.2)) << '\n';
    if (dice.chance(0.3))
        text << "\n[mortar]\ntensile_strength_pa = " << dice.logUniform(1e3, 1e6) << "\njoint_m = 0.002\n";
    for (size_t k = dice.below(3); k > 0; --k) writeCollider(dice, text);
    set.text = text.str();
    return set;
}

}  // namespace demolish::fuzz
