// SPDX-License-Identifier: Apache-2.0
// Closed meshes with known shape, shared by the unit tests of every room.
#pragma once
#include "sim_cuda/api/triangle_mesh.h"

namespace demolish::test {

// All are closed, outward-oriented and centred at the origin unless said otherwise; corners carry face
// normals and a planar projection as texture coordinates.

/// Axis-aligned cube of the given side (m), 12 triangles.
TriangleMesh makeCube(double side);

/// Ring around the y axis: centre circle R, tube radius r (m), n sections around the axis, m around the tube.
TriangleMesh makeTorus(double R, double r, int n, int m);

/// Icosahedron subdivided and projected onto radius r (m): 20 * 4^subdivisions triangles.
TriangleMesh makeSphere(double r, int subdivisions);

/// Thin-walled vase of assets.md 1.5: n sectors, r rings (>= 20), 2nr triangles; height 0.5 m, wall 14 mm,
/// bottom pole at the origin, standing upright. n = 50, r = 30 are the recipe's own rings.
TriangleMesh makeVase(int n, int r);

/// A fork of two prongs: 6 m high, 1 m deep about z = 0, on y = 0. Base to y = 1, prongs of width 1 at x = 0
/// and x = 2; up to y = 3 the right one is only `neck` (0 to 1 m) wide. Not centred.
TriangleMesh makeFork(double neck);

/// Same shape with the inside turned out (negative volume), for cavities and refusals.
TriangleMesh turnedInsideOut(TriangleMesh mesh);

/// Both meshes in one, `b` moved by `offset` (m).
TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b, const Double3& offset = {});

/// Sum of signed tetrahedra (m^3).
double signedVolume(const TriangleMesh& mesh);

}  // namespace demolish::test
