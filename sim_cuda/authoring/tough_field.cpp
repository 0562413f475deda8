// SPDX-License-Identifier: Apache-2.0
// Two kinds: irregular cells round seeds drawn from the packing, and the pieces of a pattern.
#include "sim_cuda/authoring/tough_field.h"

#include <cmath>

#include "sim_cuda/authoring/seed_grid.h"
#include "sim_cuda/patterns/fit_pattern.h"
#include "sim_cuda/physics/random.h"
#include "sim_cuda/physics/tough_cells.h"

namespace demolish {
namespace {

constexpr uint64_t kCellStream = 2;  // as the solver draws those of bodies that have none

/// Borders are bent by one octave of noise: what waves in less than kLeastWave spacings no cells can follow.
constexpr double kBendShare = 0.15;  // of the wavelength
constexpr double kWaveShare = 0.6;   // of a tough cell
constexpr double kLeastWave = 3;     // spacings

Vec3<float> single(const Double3& x) {
    return {static_cast<float>(x.x), static_cast<float>(x.y), static_cast<float>(x.z)};
}

class IrregularCells final : public ToughField {
  public:
    IrregularCells(std::vector<Double3> centres, double cell_length, double spacing, uint64_t seed)
        : centres_(std::move(centres)),
          grid_(centres_, cell_length),
          wave_(std::max(kWaveShare * cell_length, kLeastWave * spacing)),
          salt_(static_cast<uint32_t>(counterHash(seed, 0))) {}

    uint32_t cellAt(const Double3& x) const override { return grid_.nearest(bent(x)); }
    double side(const Double3& x, uint32_t a, uint32_t b) const override {
        const Double3 p = bent(x);
        return lengthSquared(p - centres_[b]) - lengthSquared(p - centres_[a]);
    }

  private:
    Double3 bent(const Double3& x) const {
        const Vec3<float> noise = valueNoise(single((1 / wave_) * x), salt_);
        return x + (kBendShare * wave_) * Double3{noise.x, noise.y, noise.z};
    }

    std::vector<Double3> centres_;
    SeedGrid grid_;
    double wave_;  // m
    uint32_t salt_;
};

class PatternCells final : public ToughField {
  public:
    PatternCells(const PiecePattern& pattern, const PatternFrame& frame) : pattern_(pattern), frame_(frame) {}

    uint32_t cellAt(const Double3& x) const override { return pieceAt(pattern_, frame_, single(x)); }
    double side(const Double3& x, uint32_t a, uint32_t b) const override {
        const Vec3<float> p = bentPlace(pattern_, frame_, single(x));
        return double{farFromPiece(pattern_, p, b)} - double{farFromPiece(pattern_, p, a)};
    }

  private:
    PiecePattern pattern_;
    PatternFrame frame_;
};

PiecePattern fitted(const ToughCellOptions& options, const PatternFrame& frame,
                    const std::vector<Double3>& seeds, double volume, uint64_t seed) {
    std::vector<Vec4<float>> rest;
    for (const Double3& x : seeds) rest.push_back({float(x.x), float(x.y), float(x.z), 0.0f});
    const PiecePattern guess{*options.pattern, static_cast<float>(std::cbrt(volume / options.cells)),
                             static_cast<uint32_t>(seed)};
    return fittedPattern(guess, frame, rest, options.cells);
}

}  // namespace

std::unique_ptr<const ToughField> makeToughField(const ToughCellOptions& options, const Double3& centre,
                                                 const std::vector<Double3>& seeds, double volume,
                                                 double spacing, uint64_t seed) {
    if (options.cells <= 1 || options.cells >= seeds.size()) return nullptr;
    const uint64_t own = counterHash(seed, kCellStream);
    if (options.pattern) {
        const PatternFrame frame = patternFrame(single(centre), normalized(single(options.axis)));
        return std::make_unique<PatternCells>(fitted(options, frame, seeds, volume, own), frame);
    }
    std::vector<Double3> centres;
    for (const uint32_t seed_of_cell : toughCellSeeds(seeds.size(), options.cells, own))
        centres.push_back(seeds[seed_of_cell]);
    return std::make_unique<IrregularCells>(std::move(centres), std::cbrt(volume / options.cells), spacing,
                                            own);
}

Double3 borderGradient(const ToughField& field, const Double3& x, uint32_t a, uint32_t b, double reach) {
    const auto along = [&](const Double3& step) {
        return field.side(x + step, a, b) - field.side(x - step, a, b);
    };
    return (0.5 / reach) * Double3{along({reach, 0, 0}), along({0, reach, 0}), along({0, 0, reach})};
}

}  // namespace demolish
