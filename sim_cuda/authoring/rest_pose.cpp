// SPDX-License-Identifier: Apache-2.0
// Targets first, then skins: v' = N^-1 (sum of w J B v), with the places N of the mesh's node and J of the
// joint, and the inverse bind matrix B (glTF 2.0, 3.7.3).
#include "sim_cuda/authoring/rest_pose.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/node_transform.h"

namespace demolish {
namespace {

aiVector3D toAssimp(const Double3& v) {
    return {ai_real(v.x), ai_real(v.y), ai_real(v.z)};
}

aiVector3D unit(const Double3& v) {
    return lengthSquared(v) > 0 ? toAssimp(normalized(v)) : aiVector3D{};
}

std::optional<NodeTransform> inverse(const NodeTransform& t) {
    const double determinant = t.determinant();
    if (!(std::abs(determinant) > 0) || !std::isfinite(determinant)) return std::nullopt;
    const Double3 a = cross(t.y, t.z) * (1 / determinant), b = cross(t.z, t.x) * (1 / determinant),
                  c = cross(t.x, t.y) * (1 / determinant);  // rows
    NodeTransform back{{a.x, b.x, c.x}, {a.y, b.y, c.y}, {a.z, b.z, c.z}, {}};
    back.origin = -back.direction(t.origin);
    return back;
}

void applyTargets(aiMesh& mesh) {
    std::vector<Double3> moves(mesh.mNumVertices), turns(mesh.mNumVertices);
    bool any = false;
    for (unsigned i = 0; i < mesh.mNumAnimMeshes; ++i) {
        const aiAnimMesh& target = *mesh.mAnimMeshes[i];
        const auto weight = double(target.mWeight);
        if (weight == 0 || !std::isfinite(weight) || target.mNumVertices != mesh.mNumVertices) continue;
        any = true;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            if (target.HasPositions())
                moves[v] += fromAssimp(target.mVertices[v] - mesh.mVertices[v]) * weight;
            if (target.HasNormals() && mesh.HasNormals())
                turns[v] += fromAssimp(target.mNormals[v] - mesh.mNormals[v]) * weight;
        }
    }
    for (unsigned v = 0; any && v < mesh.mNumVertices; ++v) {
        mesh.mVertices[v] = toAssimp(fromAssimp(mesh.mVertices[v]) + moves[v]);
        if (mesh.HasNormals()) mesh.mNormals[v] = unit(fromAssimp(mesh.mNormals[v]) + turns[v]);
    }
}

/// The first in the order of the file.
const aiNode* nodeOf(const aiNode& node, unsigned mesh) {
    if (std::find(node.mMeshes, node.mMeshes + node.mNumMeshes, mesh) != node.mMeshes + node.mNumMeshes)
        return &node;
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        if (const aiNode* found = nodeOf(*node.mChildren[i], mesh)) return found;
    return nullptr;
}

struct Posed {
    std::vector<Double3> points, normals;
    std::vector<double> weights;  // sums
};

/// Weighted sums in the file's lengths; none where a joint is not there.
std::optional<Posed> posedByJoints(const aiScene& scene, const aiMesh& mesh) {
    const size_t count = mesh.mNumVertices;
    Posed posed{std::vector<Double3>(count), std::vector<Double3>(count), std::vector<double>(count, 0)};
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const aiNode* joint = scene.mRootNode->FindNode(bone.mName);
        if (joint == nullptr) return std::nullopt;
        const NodeTransform map = chained(placeOf(*joint), bone.mOffsetMatrix);
        for (unsigned i = 0; i < bone.mNumWeights; ++i) {
            const unsigned v = bone.mWeights[i].mVertexId;
            const auto weight = double(bone.mWeights[i].mWeight);
            if (v >= count || !std::isfinite(weight)) continue;
            posed.points[v] += map.point(fromAssimp(mesh.mVertices[v])) * weight;
            posed.weights[v] += weight;
            if (mesh.HasNormals()) posed.normals[v] += map.normal(fromAssimp(mesh.mNormals[v])) * weight;
        }
    }
    return posed;
}

/// Skins that leave everything where it is, but for rounding, are left alone.
void applySkin(const aiScene& scene, unsigned number) {
    constexpr double kRounding = 1e-5;  // of the mesh's size
    aiMesh& mesh = *scene.mMeshes[number];
    const aiNode* node = mesh.mNumBones > 0 ? nodeOf(*scene.mRootNode, number) : nullptr;
    if (node == nullptr) return;
    const auto back = inverse(placeOf(*node));
    const auto posed = posedByJoints(scene, mesh);
    if (!back || !posed) return;
    std::vector<aiVector3D> points(mesh.mVertices, mesh.mVertices + mesh.mNumVertices);
    double farthest = 0, size = 0;
    for (size_t v = 0; v < points.size(); ++v) {
        const Double3 before = fromAssimp(points[v]);
        size = std::max(size, length(before - fromAssimp(points[0])));
        if (!(posed->weights[v] > 0)) continue;
        const Double3 after = back->point(posed->points[v] * (1 / posed->weights[v]));
        farthest = std::max(farthest, length(after - before));
        points[v] = toAssimp(after);
    }
    if (!(farthest > kRounding * size)) return;
    std::copy(points.begin(), points.end(), mesh.mVertices);
    for (size_t v = 0; mesh.HasNormals() && v < points.size(); ++v)
        if (posed->weights[v] > 0) mesh.mNormals[v] = toAssimp(back->normal(posed->normals[v]));
}

}  // namespace

void poseAtRest(aiScene& scene) {
    for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
        applyTargets(*scene.mMeshes[m]);
        applySkin(scene, m);
    }
}

}  // namespace demolish
