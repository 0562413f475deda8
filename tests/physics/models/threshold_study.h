// SPDX-License-Identifier: Apache-2.0
// Thresholds of six bodies, dropped and hit, over particle size: what the table of assets/strength is made
// from, and what shows that strength means the same at every size (models.md E.2).
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/calibrate/threshold_search.h"

namespace demolish::tests {

struct StudyShot {
    std::string body, kind;  ///< "rabbit"; "drop" or "ball"
    Shot shot;
    double usual_share = 1;  ///< v_th / v_c, where the search begins
};
/// sphere, cube, rabbit, column, vase, wolf, each dropped and hit. The sphere's mesh is written to `folder`.
std::vector<StudyShot> studyShots(const std::filesystem::path& folder);

/// Of a 1 m sphere that is dropped: without tough cells (ci = 1), or with K = 40.
StudyShot sphereDrop(const std::filesystem::path& folder, double tough_factor);

struct StudyCase {
    const StudyShot* shot;
    uint32_t particles = 0, packings = 1;
    double tolerance = 0.06;
    TrialOptions trial;
    uint32_t first_packing = 0;  ///< so that processes can share a case
};
struct StudyResult {
    double size_ratio = 0;                ///< D/h, D = diameter of the sphere of equal volume
    double body_mass = 0, ball_mass = 0;  ///< kg
    uint32_t substeps = 0;
    MeasuredThreshold threshold;
    double spread() const;  ///< standard deviation over mean of the packings; 0 of one
};
StudyResult runCase(const StudyCase& wanted);

}  // namespace demolish::tests
