// SPDX-License-Identifier: Apache-2.0
// Evens out a marched surface so that decimation starts from good triangles.
#pragma once
#include "assets/models/field.h"
#include "assets/models/surface.h"

namespace demolish::sculptor {

/// `passes` times: moves each vertex 60 % towards its neighbours' mean, then takes two Newton steps back onto
/// the field's zero surface, none longer than `cell`. All vertices move at once, so threads do not change the
/// result.
void relax(Surface& surface, const Field& field, double cell, int passes);

}  // namespace demolish::sculptor
