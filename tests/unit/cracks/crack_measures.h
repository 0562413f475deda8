// SPDX-License-Identifier: Apache-2.0
// The measures of docs/looks.md 4 that are geometry.
#pragma once
#include <cstddef>

#include "app/compare/crack_outlines.h"
#include "tests/unit/draw/drawn_surface.h"

namespace demolish::test {

struct CrackMeasures {
    size_t pieces = 0, large_pieces = 0;
    LineMeasure outline;          ///< of borders on the outside between large pieces
    LineMeasure outline_at_rest;  ///< the same along the cells' own borders
    double faces = 0;             ///< rms over h of faces between large pieces from a local quadratic fit
    double face_area = 0;         ///< h^2, of those
    size_t flipped = 0;           ///< parts of the outside that are turned over
    size_t parts = 0;             ///< of the outside
    double flipped_area = 0;      ///< share of the outside
    size_t open_edges = 0;        ///< of all pieces; 0: both sides of every face coincide, rims included
    double volume_error = 0;      ///< of all pieces together, over the body's
};

/// `h`: m, spacing; `volume`: m^3, of all bodies.
CrackMeasures measureCracks(DrawnSurface& drawn, double h, double volume);

}  // namespace demolish::test
