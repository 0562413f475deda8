// SPDX-License-Identifier: Apache-2.0
// The table of assets/strength: at which velocity bodies break, before anything is simulated.
#pragma once
#include <string>
#include <vector>

#include "app/session/shot.h"
#include "sim_cuda/api/breakable_body.h"

namespace demolish {

/// What a threshold hangs on besides the material.
struct ImpactFeatures {
    double size_ratio = 0;  ///< D/h, D = diameter of the sphere of the body's volume
    double slimness = 1;    ///< 6 V / (A D): 1 of a sphere, small of slender bodies and thin walls
    double mass_ratio = 0;  ///< the ball's mass over the body's; 0: the body is dropped
};
/// Of the shot's fastest ball, or of its drop if `kind` says so.
ImpactFeatures impactFeatures(const Shot& shot, const BreakableBody& body, ImpactKind kind);

class ThresholdTable {
  public:
    /// Throws InputFileError.
    explicit ThresholdTable(const std::filesystem::path& file);
    /// assets/strength/thresholds.toml, read once. Throws InputFileError.
    static const ThresholdTable& ofAssets();

    /// beta at which the threshold of a dropped sphere is v_c; between the rows of tough_factor the table is
    /// interpolated, beyond them it ends.
    double sphereBeta(const Material& material, double size_ratio) const;

    struct Prediction {
        double share = 0;       ///< v_th / v_c
        double scatter = 1;     ///< as a factor: the threshold lies between share/scatter and share*scatter
        bool is_known = false;  ///< the body has a row of its own; else from its shape and the ball's mass
        double wake_share = 0;  ///< as `share`; what the speed goes by at which rigid pieces wake
    };
    /// `row`: one of rows(); any other, and the body goes by its shape and the ball's mass.
    Prediction predict(const std::string& row, const Material& material,
                       const ImpactFeatures& features) const;
    /// Names of the bodies that the table knows.
    std::vector<std::string> rows() const;

  private:
    struct BetaRow {
        double tough_factor = 1, at_12 = 0, exponent = 0;
    };
    struct BodyRow {
        std::string name;
        double drop = 0, drop_scatter = 0, ball = 0, ball_mass_ratio = 0, ball_scatter = 0;
        double wake_drop = 0;  ///< in place of `drop` for waking; 0: the same
    };
    struct Rule {
        double scale = 1, slimness_exponent = 0, mass_exponent = 0, scatter = 1;
    };
    const BodyRow* rowOf(const std::string& name) const;

    std::vector<BetaRow> betas_;
    std::vector<BodyRow> bodies_;
    Rule drop_, ball_;
};

}  // namespace demolish
