// SPDX-License-Identifier: Apache-2.0
// Where the nodes of a model file lie.
#pragma once
#include <assimp/scene.h>

#include "sim_cuda/authoring/double3.h"

namespace demolish {

/// Affine map of one scene node, in doubles so that deep hierarchies lose nothing.
struct NodeTransform {
    Double3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, origin;  // images of the axes

    Double3 direction(const Double3& v) const { return x * v.x + y * v.y + z * v.z; }
    Double3 point(const Double3& p) const { return direction(p) + origin; }
    double determinant() const { return dot(x, cross(y, z)); }
    /// Normals go with the cofactors; the sign keeps them outward under a mirror.
    Double3 normal(const Double3& n) const {
        const Double3 image = cross(y, z) * n.x + cross(z, x) * n.y + cross(x, y) * n.z;
        return normalized(determinant() < 0 ? -image : image);
    }
};

inline NodeTransform chained(const NodeTransform& parent, const aiMatrix4x4& m) {
    return {parent.direction({m.a1, m.b1, m.c1}), parent.direction({m.a2, m.b2, m.c2}),
            parent.direction({m.a3, m.b3, m.c3}), parent.point({m.a4, m.b4, m.c4})};
}

/// From the node's own lengths to the file's.
inline NodeTransform placeOf(const aiNode& node) {
    return chained(node.mParent != nullptr ? placeOf(*node.mParent) : NodeTransform{}, node.mTransformation);
}

inline Double3 fromAssimp(const aiVector3D& v) {
    return {double(v.x), double(v.y), double(v.z)};
}

}  // namespace demolish
