// SPDX-License-Identifier: Apache-2.0
// Rows, the rule for bodies without a row, interpolation of beta.
#include "app/session/threshold_table.h"

#include <algorithm>
#include <cmath>

#include "app/session/ball_flight.h"
#include "app/session/data_folder.h"
#include "app/session/toml_reader.h"

namespace demolish {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kReferenceRatio = 12.4;  // D/h of `at_12`: 1,000 particles
constexpr Range kFactor{1e-3, 1e3}, kExponent{-10, 10}, kShare{1e-3, 1};

double interpolated(double low, double high, double t) {
    return low + t * (high - low);
}

}  // namespace

ImpactFeatures impactFeatures(const Shot& shot, const BreakableBody& body, ImpactKind kind) {
    ImpactFeatures features;
    const double diameter = std::cbrt(6 * body.mesh_volume / kPi);
    features.size_ratio = diameter / body.spacing;
    features.slimness = 6 * body.mesh_volume / (body.mesh_area * diameter);
    if (kind != ImpactKind::kBall) return features;
    const double radius = fastestBall(shot).radius.value_or(ballRadius(shot, body));
    const double ball = Projectile{}.density * 4.0 / 3 * kPi * radius * radius * radius;
    features.mass_ratio = ball / (shot.material.density * body.mesh_volume);
    return features;
}

ThresholdTable::ThresholdTable(const std::filesystem::path& file) {
    TomlReader reader(file);
    uint32_t version = 0;
    reader.read("version", version, {1, 1});
    betas_.resize(reader.count("beta", 100));
    for (size_t i = 0; i < betas_.size(); ++i) {
        const std::string at = "beta[" + std::to_string(i) + "].";
        reader.read(at + "tough_factor", betas_[i].tough_factor, {1, 100});
        reader.read(at + "at_12", betas_[i].at_12, {0.01, 10});
        reader.read(at + "exponent", betas_[i].exponent, kExponent);
        if (i > 0 && betas_[i].tough_factor <= betas_[i - 1].tough_factor)
            reader.fail(at + "tough_factor", "must be above that of the row before");
    }
    if (betas_.empty()) reader.fail("beta", "is missing");
    bodies_.resize(reader.count("body", 1000));
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const std::string at = "body[" + std::to_string(i) + "].";
        BodyRow& row = bodies_[i];
        reader.read(at + "name", row.name);
        reader.read(at + "drop", row.drop, kFactor);
        reader.read(at + "drop_scatter", row.drop_scatter, kShare);
        reader.read(at + "ball", row.ball, kFactor);
        reader.read(at + "ball_mass_ratio", row.ball_mass_ratio, {1e-9, 1e9});
        reader.read(at + "ball_scatter", row.ball_scatter, kShare);
        if (reader.has(at + "wake_drop")) reader.read(at + "wake_drop", row.wake_drop, kFactor);
    }
    for (Rule* rule : {&drop_, &ball_}) {
        const std::string at = rule == &drop_ ? "rule.drop." : "rule.ball.";
        reader.read(at + "scale", rule->scale, {1e-6, 1e6});
        reader.read(at + "slimness_exponent", rule->slimness_exponent, kExponent);
        if (rule == &ball_) reader.read(at + "mass_exponent", rule->mass_exponent, kExponent);
        reader.read(at + "scatter", rule->scatter, {1, 100});
    }
    reader.requireAllRead();
}

const ThresholdTable& ThresholdTable::ofAssets() {
    static const ThresholdTable kTable(dataFolder() / "assets" / "strength" / "thresholds.toml");
    return kTable;
}

double ThresholdTable::sphereBeta(const Material& material, double size_ratio) const {
    const double wanted = material.tough_cells == 0 ? 1 : std::max(1.0, material.tough_factor);
    const auto above = std::find_if(betas_.begin(), betas_.end(),
                                    [&](const BetaRow& row) { return row.tough_factor >= wanted; });
    const BetaRow& high = above == betas_.end() ? betas_.back() : *above;
    const BetaRow& low = above == betas_.begin() || above == betas_.end() ? high : *(above - 1);
    const double t = &low == &high ? 0 : (wanted - low.tough_factor) / (high.tough_factor - low.tough_factor);
    return interpolated(low.at_12, high.at_12, t) *
           std::pow(size_ratio / kReferenceRatio, interpolated(low.exponent, high.exponent, t));
}

std::vector<std::string> ThresholdTable::rows() const {
    std::vector<std::string> names;
    for (const BodyRow& row : bodies_) names.push_back(row.name);
    return names;
}

const ThresholdTable::BodyRow* ThresholdTable::rowOf(const std::string& name) const {
    const auto found =
        std::find_if(bodies_.begin(), bodies_.end(), [&](const BodyRow& row) { return row.name == name; });
    return found == bodies_.end() ? nullptr : &*found;
}

ThresholdTable::Prediction ThresholdTable::predict(const std::string& row_name, const Material& material,
                                                   const ImpactFeatures& features) const {
    const bool drop = !(features.mass_ratio > 0);
    const Rule& rule = drop ? drop_ : ball_;
    Prediction prediction;
    double factor = 0, wakes = 0;
    if (const BodyRow* row = rowOf(row_name)) {
        prediction.is_known = true;
        prediction.scatter = 1 + (drop ? row->drop_scatter : row->ball_scatter);
        factor = drop ? row->drop
                      : row->ball * std::pow(features.mass_ratio / row->ball_mass_ratio, rule.mass_exponent);
        if (drop) wakes = row->wake_drop;
    } else {
        prediction.scatter = rule.scatter;
        factor = rule.scale * std::pow(features.slimness, rule.slimness_exponent) *
                 (drop ? 1 : std::pow(features.mass_ratio, rule.mass_exponent));
    }
    const double shares = material.beta / sphereBeta(material, features.size_ratio);
    prediction.share = factor * shares;
    prediction.wake_share = (wakes > 0 ? wakes : factor) * shares;
    return prediction;
}

}  // namespace demolish
