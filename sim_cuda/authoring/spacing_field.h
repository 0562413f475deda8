// SPDX-License-Identifier: Apache-2.0
// How large cells are to be, as a function of the place.
#pragma once
#include "sim_cuda/api/authoring.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/mesh_queries.h"

namespace demolish {

/// Spacing (m, > 0) of particles round a place.
class SpacingField {
  public:
    /// The same everywhere.
    explicit SpacingField(double everywhere) : finest_(everywhere) {}
    /// Finest where the shot is aimed, `factor` (above 1) times as coarse at the way and the depth, together,
    /// of `reach` m from there, and so that cells of a mean volume of `cell_volume` (m^3) fill the solid. The
    /// grid has nodes inside. Keeps a reference to it.
    SpacingField(double factor, const Double3& aim, double reach, double cell_volume,
                 const DistanceGrid& grid);

    double at(const Double3& x) const { return finest_ * share(x); }
    double coarsest() const { return factor_ * finest_; }
    bool isEven() const { return factor_ == 1; }

  private:
    double share(const Double3& x) const;

    double finest_, factor_ = 1, reach_ = 1;
    Double3 aim_;
    const DistanceGrid* grid_ = nullptr;
};

}  // namespace demolish
