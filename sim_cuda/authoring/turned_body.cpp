// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/api/turned_body.h"

#include <algorithm>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/physics/quaternion.h"
#include "sim_cuda/physics/vertex_packing.h"
#include "sim_cuda/physics/vertex_unpacking.h"

namespace demolish {
namespace {

/// Turns in place.
class Turn {
  public:
    explicit Turn(const Quaternion& turn)
        : x_(image(turn, {1, 0, 0})), y_(image(turn, {0, 1, 0})), z_(image(turn, {0, 0, 1})) {}

    Double3 of(const Double3& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
    void apply(Double3& v) const { v = of(v); }
    void apply(Float3& v) const {
        const Double3 turned = of({v.x, v.y, v.z});
        v = {static_cast<float>(turned.x), static_cast<float>(turned.y), static_cast<float>(turned.z)};
    }
    /// Octahedral.
    void apply(uint32_t& direction) const {
        const Vec3<float> before = unpackOctahedral(direction);
        Float3 turned{before.x, before.y, before.z};
        apply(turned);
        direction = packOctahedral(turned.x, turned.y, turned.z);
    }
    /// R T R^t, row by row.
    void apply(SymmetricTensor& t) const {
        const auto through = [&t](const Double3& v) {
            return Double3{t.xx * v.x + t.xy * v.y + t.zx * v.z, t.xy * v.x + t.yy * v.y + t.yz * v.z,
                           t.zx * v.x + t.yz * v.y + t.zz * v.z};
        };
        const Double3 rows[] = {{x_.x, y_.x, z_.x}, {x_.y, y_.y, z_.y}, {x_.z, y_.z, z_.z}};
        const Double3 a = through(rows[0]), b = through(rows[1]), c = through(rows[2]);
        t = {dot(rows[0], a), dot(rows[1], b), dot(rows[2], c),
             dot(rows[0], b), dot(rows[1], c), dot(rows[2], a)};
    }

  private:
    static Double3 image(const Quaternion& q, const Vec3<double>& axis) {
        const Vec3<double> turned = rotate(normalized(Quat<double>{q.x, q.y, q.z, q.w}), axis);
        return {turned.x, turned.y, turned.z};
    }
    Double3 x_, y_, z_;  ///< images of the axes
};

void turnGeometry(const Turn& turn, FractureGeometry& geometry) {
    for (SurfaceVertex& vertex : geometry.exterior) {
        turn.apply(vertex.position);
        turn.apply(vertex.normal);
    }
    for (Float3& point : geometry.pool) turn.apply(point);
    for (OutsidePoint& point : geometry.points) {
        turn.apply(point.position);
        turn.apply(point.normal);
        turn.apply(point.axis);
    }
    for (MeshTriangle& triangle : geometry.mesh_triangles)
        for (int c = 0; c < 3; ++c) {
            turn.apply(triangle.corner[c]);
            turn.apply(triangle.normal[c]);
        }
}

/// The lowest corner of each cell; of cells without corners as far below the seed as it is deep.
void findLowest(BreakableBody& body) {
    for (size_t i = 0; i < body.particles.size(); ++i) {
        Particle& particle = body.particles[i];
        particle.lowest = particle.seed.y - particle.depth;
        if (body.corners.start.empty()) continue;
        for (uint32_t c = body.corners.start[i]; c < body.corners.start[i + 1]; ++c)
            particle.lowest = std::min(particle.lowest, particle.seed.y + body.corners.from_seed[c].y);
    }
}

/// Round the outside that is drawn, else round the seeds.
void findBounds(BreakableBody& body) {
    Double3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    const auto add = [&](const Double3& p) {
        low = minimum(low, p);
        high = maximum(high, p);
    };
    for (const SurfaceVertex& v : body.geometry.exterior) add({v.position.x, v.position.y, v.position.z});
    if (body.geometry.exterior.empty())
        for (const Particle& particle : body.particles) add(particle.seed);
    body.bounds_min = low;
    body.bounds_max = high;
}

}  // namespace

std::shared_ptr<const BreakableBody> turnedBody(const BreakableBody& body, const Quaternion& by) {
    const Turn turn(by);
    auto turned = std::make_shared<BreakableBody>(body);
    for (Particle& particle : turned->particles) {
        turn.apply(particle.seed);
        turn.apply(particle.centroid);
        turn.apply(particle.inertia);
    }
    for (BondGeometry& bond : turned->bonds) {
        turn.apply(bond.centroid);
        turn.apply(bond.normal);
    }
    for (Double3& corner : turned->corners.from_seed) turn.apply(corner);
    turnGeometry(turn, turned->geometry);
    findLowest(*turned);
    findBounds(*turned);
    return turned;
}

}  // namespace demolish
