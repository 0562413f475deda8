// Key and file of one measured threshold.
#include "app/session/threshold_cache.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/session/ball_flight.h"
#include "app/session/output_file.h"

namespace demolish {
namespace fs = std::filesystem;
namespace {

/// Raised when trials, solver or criterion change so that old measurements no longer hold.
constexpr uint32_t kMeasurementVersion = 1;

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
    if (ball.body < shot.bodies.size()) hash.add(shot.bodies[ball.body].yaw);
    hash.add(ball.radius.value_or(ballRadius(shot, body)));
    hash.add(ball.direction.value_or(impact.direction));
    hash.add(ball.height_fraction.value_or(impact.height_fraction));
    hash.add(ball.aim.value_or(Double3{}));
    hash.add(ball.aim.has_value());
    hash.add(shot.settle_time);
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

}  // namespace

std::optional<CachedThreshold> readCachedThreshold(const fs::path& folder, uint64_t key) {
    if (folder.empty()) return std::nullopt;
    std::ifstream in(fileOf(folder, key));
    if (!in) return std::nullopt;
    const auto json = nlohmann::json::parse(in, nullptr, false);
    try {
        CachedThreshold cached;
        json.at("share").get_to(cached.share);
        json.at("lowest_share").get_to(cached.lowest);
        json.at("highest_share").get_to(cached.highest);
        json.at("critical_velocity_mps").get_to(cached.critical_velocity);
        json.at("packings").get_to(cached.packings);
        json.at("tolerance").get_to(cached.tolerance);
        if (cached.share > 0) return cached;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;  // a damaged file is measured anew and written over
    }
    return std::nullopt;
}

void writeCachedThreshold(const fs::path& folder, uint64_t key, const CachedThreshold& threshold) {
    if (folder.empty()) return;
    makeOutputFolder(folder);
    const nlohmann::ordered_json json{
        {"share", threshold.share},           {"lowest_share", threshold.lowest},
        {"highest_share", threshold.highest}, {"critical_velocity_mps", threshold.critical_velocity},
        {"packings", threshold.packings},     {"tolerance", threshold.tolerance}};
    writeTextFile(fileOf(folder, key), json.dump(2) + "\n");
}

}  // namespace demolish
