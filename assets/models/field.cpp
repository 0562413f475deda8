// SPDX-License-Identifier: Apache-2.0
// Evaluates a recipe's parts in their order.
#include "assets/models/field.h"

#include <algorithm>
#include <limits>

namespace demolish::sculptor {
namespace {

void include(Box& box, Vec3 centre, double reach) {
    box.low = {std::min(box.low.x, centre.x - reach), std::min(box.low.y, centre.y - reach),
               std::min(box.low.z, centre.z - reach)};
    box.high = {std::max(box.high.x, centre.x + reach), std::max(box.high.y, centre.y + reach),
                std::max(box.high.z, centre.z + reach)};
}

/// A ball around each end holds a part; a smooth union grows it by a quarter of its radius.
void include(Box& box, const Part& part) {
    const double growth = part.blend / 4;
    const Vec3 r = part.radii;
    const Vec3 ends[] = {part.a, part.kind == PartKind::kEllipsoid ? part.a : part.b};
    const double reach[] = {part.kind == PartKind::kEllipsoid ? std::max({r.x, r.y, r.z}) : part.ra,
                            part.kind == PartKind::kEllipsoid ? 0 : part.rb};
    for (int i = 0; i < 2; ++i) {
        include(box, ends[i], reach[i] + growth);
        if (part.mirrored) include(box, {-ends[i].x, ends[i].y, ends[i].z}, reach[i] + growth);
    }
}

/// A blade is a round cone in coordinates that begin at `a`, turned by yaw and stretched across its
/// thickness.
Vec3 bladeCoordinates(const Frame& frame, const Part& part, Vec3 p) {
    const Vec3 local = frame.toLocal(p - part.a);
    return {local.x, local.y, local.z / part.flat};
}

}  // namespace

Field::Field(const FieldRecipe& recipe)
    : coat_(recipe.coat), bounds_{recipe.parts.front().a, recipe.parts.front().a} {
    for (const Part& part : recipe.parts) {
        parts_.push_back(prepare(part));
        if (!part.carves) include(bounds_, part);
    }
}

Field::Prepared Field::prepare(const Part& part) {
    Prepared prepared{part, Frame::of(part.turn), {}, part.a};
    if (part.kind == PartKind::kEllipsoid) {
        // k0 / k1 is at least the smallest radius and k0 at least |p| over the largest.
        const double smallest = std::min({part.radii.x, part.radii.y, part.radii.z});
        prepared.slope = smallest / std::max({part.radii.x, part.radii.y, part.radii.z});
        prepared.offset = smallest;
    } else if (part.kind == PartKind::kCone) {
        prepared.centre = 0.5 * (part.a + part.b);
        prepared.slope = 1;
        prepared.offset = 0.5 * length(part.b - part.a) + std::max(part.ra, part.rb);
    } else {
        prepared.end = bladeCoordinates(prepared.frame, part, part.b);
        prepared.offset = std::numeric_limits<double>::infinity();  // few enough to ask always
    }
    return prepared;
}

double Field::leastDistance(const Prepared& prepared, Vec3 p) {
    if (prepared.part.mirrored && (p.x < 0) != (prepared.centre.x < 0)) p.x = -p.x;
    return prepared.slope * length(p - prepared.centre) - prepared.offset;
}

double Field::distance(const Prepared& prepared, Vec3 p) {
    const Part& part = prepared.part;
    switch (part.kind) {
        case PartKind::kEllipsoid:
            return ellipsoidDistance(prepared.frame.toLocal(p - part.a), part.radii);
        case PartKind::kCone:
            return roundConeDistance(p, part.a, part.ra, part.b, part.rb);
        case PartKind::kBlade:
            break;
    }
    // The stretch makes distances across the blade too long; the factor makes them safe to step along.
    const Vec3 q = bladeCoordinates(prepared.frame, part, p);
    return roundConeDistance(q, {}, part.ra, prepared.end, part.rb) * std::min(1.0, 1.4 * part.flat);
}

double Field::at(Vec3 p) const {
    double body = 0;
    for (size_t i = 0; i < parts_.size(); ++i) {
        const Part& part = parts_[i].part;
        // A part farther away than this leaves the value as it is, to the bit; most are.
        const double out_of_reach = part.blend + (part.carves ? -body : body) + 1e-9;
        if (i > 0 && leastDistance(parts_[i], p) > out_of_reach) continue;
        double d = distance(parts_[i], p);
        if (part.mirrored) d = std::min(d, distance(parts_[i], {-p.x, p.y, p.z}));
        if (i == 0)
            body = d;
        else
            body = part.carves ? smoothSubtraction(body, d, part.blend) : smoothUnion(body, d, part.blend);
    }
    if (coat_ && std::abs(body) < coat_->reach) body -= coatRelief(*coat_, p);
    return body;
}

Vec3 Field::gradient(Vec3 p, double h) const {
    const double s = 1 / (2 * h);
    return {s * (at({p.x + h, p.y, p.z}) - at({p.x - h, p.y, p.z})),
            s * (at({p.x, p.y + h, p.z}) - at({p.x, p.y - h, p.z})),
            s * (at({p.x, p.y, p.z + h}) - at({p.x, p.y, p.z - h}))};
}

}  // namespace demolish::sculptor
