// SPDX-License-Identifier: Apache-2.0
// Key and file of one measured threshold.
#include "app/session/threshold_cache.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/session/ball_flight.h"
#include "app/session/json_text.h"
#include "app/session/output_file.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

/// Raised when trials, solver or criterion change so that old measurements no longer hold.
constexpr uint32_t kMeasurementVersion = 3;

/// FNV-1a over values, bit by bit.
class Hash {
  public:
    template <class Value>
    void add(const Value& value) {
        static_assert(std::is_arithmetic_v<Value> || std::is_enum_v<Value>);
        unsigned char bytes[sizeof(Value)];
        std::memcpy(bytes, &value, sizeof(Value));
        for (const unsigned char byte : bytes) state_ = (state_ ^ byte) * 0x100000001b3ull;
    }
    void add(const Double3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    uint64_t value() const { return state_; }

  private:
    uint64_t state_ = 0xcbf29ce484222325ull;
};

void addBody(const BreakableBody& body, Hash& hash) {
    hash.add(body.particles.size());
    for (const Particle& particle : body.particles) {
        hash.add(particle.seed);
        hash.add(particle.volume);
    }
    hash.add(body.bonds.size());
    for (const BondGeometry& bond : body.bonds) hash.add(bond.area);
    for (const uint32_t cell : body.tough_cell) hash.add(cell);
    for (const double factor : body.bond_strength) hash.add(factor);
}

void addMaterial(const Material& m, Hash& hash) {
    for (const double value :
         {m.density, m.poisson_ratio, m.friction, m.restitution, m.rolling_friction, m.damping_ratio, m.beta,
          m.weibull_modulus, m.tough_factor, m.adhesion_energy, m.shear_ratio})
        hash.add(value);
    hash.add(m.tough_cells);
    hash.add(m.bond_law);
}

void addImpact(const Shot& shot, const BreakableBody& body, Hash& hash) {
    const Impact& impact = shot.impact;
    hash.add(impact.kind);
    if (impact.kind == ImpactKind::kDrop) return hash.add(impact.tilt);
    const TimedBall ball = fastestBall(shot);
    if (ball.body < shot.bodies.size()) {
        const SceneBody& hit = shot.bodies[ball.body];
        hash.add(hit.yaw);
        for (const double part : {hit.turn.x, hit.turn.y, hit.turn.z})
            if (part != 0) hash.add(part);
    }
    hash.add(ball.radius.value_or(ballRadius(shot, body)));
    hash.add(ball.direction.value_or(impact.direction));
    hash.add(ball.height_fraction ? *ball.height_fraction : impact.height_fraction.value_or(-1));
    hash.add(ball.aim.value_or(Double3{}));
    hash.add(ball.aim.has_value());
    hash.add(shot.settle_time * shot.settle_scale);
}

}  // namespace

fs::path thresholdCacheFolder() {
    const char* const cache = std::getenv("XDG_CACHE_HOME");
    if (cache != nullptr && *cache != '\0') return fs::path(cache) / "demolish" / "thresholds";
    const char* const home = std::getenv("HOME");
    if (home != nullptr && *home != '\0') return fs::path(home) / ".cache" / "demolish" / "thresholds";
    return {};
}

uint64_t thresholdKey(const Shot& shot, const BreakableBody& body) {
    Hash hash;
    hash.add(kMeasurementVersion);
    hash.add(shot.seed);
    hash.add(shot.wave_speed);
    hash.add(shot.substeps.value_or(0));
    addBody(body, hash);
    addMaterial(shot.material, hash);
    addImpact(shot, body, hash);
    return hash.value();
}

namespace {

fs::path fileOf(const fs::path& folder, uint64_t key) {
    char name[32];
    std::snprintf(name, sizeof name, "%016llx.json", static_cast<unsigned long long>(key));
    return folder / name;
}

/// Critical velocities, and velocities to break at, within this share are one and the same.
constexpr double kSameStrength = 0.01, kSameVelocity = 0.005;

bool isFoundFor(const CachedThreshold& point, double break_at) {
    return std::abs(point.break_at / break_at - 1) < kSameVelocity;
}

CachedThreshold pointOf(const nlohmann::json& json) {
    CachedThreshold point;
    json.at("share").get_to(point.share);
    json.at("lowest_share").get_to(point.lowest);
    json.at("highest_share").get_to(point.highest);
    json.at("critical_velocity_mps").get_to(point.critical_velocity);
    json.at("packings").get_to(point.packings);
    json.at("tolerance").get_to(point.tolerance);
    point.break_at = json.value("break_at_mps", 0.0);
    return point;
}

nlohmann::ordered_json jsonOf(const CachedThreshold& point) {
    return {{"share", point.share},           {"lowest_share", point.lowest},
            {"highest_share", point.highest}, {"critical_velocity_mps", point.critical_velocity},
            {"packings", point.packings},     {"tolerance", point.tolerance},
            {"break_at_mps", point.break_at}};
}

double velocityOf(const CachedThreshold& point) {
    return point.share * point.critical_velocity;
}

/// d ln v_th / d ln v_c between two strengths.
double slopeBetween(const CachedThreshold& a, const CachedThreshold& b) {
    return std::log(velocityOf(b) / velocityOf(a)) / std::log(b.critical_velocity / a.critical_velocity);
}

/// The same beyond the first or last one: of the two next to it, as far as scatter leaves it likely.
double slopeBeyond(const CachedThresholds& measured, bool above) {
    if (measured.size() < 2) return 1;
    const size_t k = above ? measured.size() - 1 : 1;
    return std::clamp(slopeBetween(measured[k - 1], measured[k]), 0.5, 1.0);
}

}  // namespace

CachedThresholds readCachedThresholds(const fs::path& folder, uint64_t key) {
    CachedThresholds measured;
    if (folder.empty()) return measured;
    std::error_code ignored;
    if (!fs::is_regular_file(fileOf(folder, key), ignored)) return measured;
    std::ifstream in(fileOf(folder, key));
    if (!in) return measured;
    const auto json = nlohmann::json::parse(in, nullptr, false);
    try {
        for (const auto& point : json.at("measured")) {
            const CachedThreshold read = pointOf(point);
            if (read.share > 0 && read.critical_velocity > 0) keep(read, measured);
        }
    } catch (const nlohmann::json::exception&) {
        return {};  // a damaged file is measured anew and written over
    }
    return measured;
}

void writeCachedThreshold(const fs::path& folder, uint64_t key, const CachedThreshold& threshold) {
    if (folder.empty()) return;
    CachedThresholds measured = readCachedThresholds(folder, key);
    keep(threshold, measured);
    nlohmann::ordered_json json{{"measured", nlohmann::ordered_json::array()}};
    for (const CachedThreshold& point : measured) json["measured"].push_back(jsonOf(point));
    try {
        makeOutputFolder(folder);
        writeTextFile(fileOf(folder, key), jsonText(json, 2) + "\n");
    } catch (const OutputError& error) {  // minutes of measuring must not be lost for it
        spdlog::warn("the threshold is measured, but not kept for the next time: {}", error.what());
    }
}

void keep(const CachedThreshold& threshold, CachedThresholds& among) {
    std::erase_if(among, [&](const CachedThreshold& point) {
        return std::abs(point.critical_velocity / threshold.critical_velocity - 1) < kSameStrength;
    });
    if (threshold.break_at > 0)
        for (CachedThreshold& point : among)
            if (isFoundFor(point, threshold.break_at)) point.break_at = 0;
    const auto stronger = std::find_if(among.begin(), among.end(), [&](const CachedThreshold& point) {
        return point.critical_velocity > threshold.critical_velocity;
    });
    among.insert(stronger, threshold);
}

const CachedThreshold* measuredAt(const CachedThresholds& measured, double critical_velocity) {
    for (const CachedThreshold& point : measured)
        if (std::abs(point.critical_velocity / critical_velocity - 1) < kSameStrength) return &point;
    return nullptr;
}

const CachedThreshold* foundFor(const CachedThresholds& measured, double break_at) {
    for (const CachedThreshold& point : measured)
        if (isFoundFor(point, break_at)) return &point;
    return nullptr;
}

double shareAt(const CachedThresholds& measured, double critical_velocity) {
    const auto from = [&](const CachedThreshold& point, double slope) {
        return point.share * std::pow(critical_velocity / point.critical_velocity, slope - 1);
    };
    if (critical_velocity <= measured.front().critical_velocity)
        return from(measured.front(), slopeBeyond(measured, false));
    for (size_t k = 1; k < measured.size(); ++k)
        if (critical_velocity <= measured[k].critical_velocity)
            return from(measured[k], slopeBetween(measured[k - 1], measured[k]));
    return from(measured.back(), slopeBeyond(measured, true));
}

double criticalVelocityAt(const CachedThresholds& measured, double velocity) {
    const auto from = [&](const CachedThreshold& point, double slope) {
        return point.critical_velocity * std::pow(velocity / velocityOf(point), 1 / slope);
    };
    if (velocity <= velocityOf(measured.front())) return from(measured.front(), slopeBeyond(measured, false));
    for (size_t k = 1; k < measured.size(); ++k)
        // Two that scatter has turned round say nothing about what lies between them.
        if (velocity <= velocityOf(measured[k]) && velocityOf(measured[k - 1]) < velocityOf(measured[k]))
            return from(measured[k], slopeBetween(measured[k - 1], measured[k]));
    return from(measured.back(), slopeBeyond(measured, true));
}

}  // namespace demolish
