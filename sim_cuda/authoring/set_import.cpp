// SPDX-License-Identifier: Apache-2.0
// What stands in a file, without its triangles.
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#include <cmath>

#include "sim_cuda/api/model_set.h"
#include "sim_cuda/authoring/camera_import.h"
#include "sim_cuda/authoring/model_nodes.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/node_transform.h"
#include "sim_cuda/authoring/scene_reading.h"
#include "sim_cuda/authoring/thing_motion.h"

namespace demolish {
namespace {

struct Box {
    Double3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    size_t triangles = 0;

    void add(const Double3& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
};

void addMesh(const aiMesh& mesh, const NodeTransform& place, const std::filesystem::path& file, Box& box) {
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;
        ++box.triangles;
        for (unsigned k = 0; k < 3; ++k) {
            if (face.mIndices[k] >= mesh.mNumVertices) refuseModel(file, kNoSuchVertex);
            const Double3 p = place.point(fromAssimp(mesh.mVertices[face.mIndices[k]]));
            if (!isFinite(p)) refuseModel(file, kEndlessNumber);
            box.add(p);
        }
    }
}

void addNode(const aiScene& scene, const aiNode& node, bool with_all_below, const std::filesystem::path& file,
             Box& box) {
    const NodeTransform place = placeOf(node);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) refuseModel(file, kNoSuchPart);
        addMesh(*scene.mMeshes[node.mMeshes[i]], place, file, box);
    }
    if (!with_all_below) return;
    for (unsigned i = 0; i < node.mNumChildren; ++i) addNode(scene, *node.mChildren[i], true, file, box);
}

bool hasRoleByName(const std::string& name) {
    return name.starts_with(kColliderPrefix) || name.starts_with(kAnchorPrefix);
}

bool isBelow(const aiNode* node, const aiNode* above) {
    while (node != nullptr && node != above) node = node->mParent;
    return node != nullptr;
}

/// In the order of the file; what a group stands for is not there a second time.
std::vector<SetThing> thingsOf(const aiScene& scene, const std::filesystem::path& file) {
    std::vector<SetThing> things;
    const aiNode* group = nullptr;
    for (const NamedNode& named : namedNodes(*scene.mRootNode)) {
        if (group != nullptr && isBelow(named.node, group)) continue;
        const bool is_group = named.node->mNumMeshes == 0 && hasRoleByName(named.name);
        if (named.node->mNumMeshes == 0 && !is_group) continue;
        if (is_group) group = named.node;
        Box box;
        addNode(scene, *named.node, is_group, file, box);
        if (box.triangles == 0) continue;
        things.push_back({named.name, box.low, box.high, box.triangles, {}});
        if (!hasRoleByName(named.name)) things.back().motion = motionOf(scene, *named.node, things.back());
    }
    return things;
}

std::optional<SetSun> sunOf(const aiScene& scene) {
    for (unsigned l = 0; l < scene.mNumLights; ++l) {
        const aiLight& light = *scene.mLights[l];
        if (light.mType != aiLightSource_DIRECTIONAL) continue;
        const aiNode* node = scene.mRootNode->FindNode(light.mName);
        const NodeTransform place = node != nullptr ? placeOf(*node) : NodeTransform{};
        const Double3 way = normalized(place.direction(fromAssimp(light.mDirection)));
        const Double3 colour{double(light.mColorDiffuse.r), double(light.mColorDiffuse.g),
                             double(light.mColorDiffuse.b)};
        if (isFinite(way) && isFinite(colour)) return SetSun{way, maximum(colour, {})};
    }
    return std::nullopt;
}

}  // namespace

ModelSet importSet(const std::filesystem::path& file) {
    Assimp::Importer importer;
    const aiScene& scene = readScene(importer, file);
    ModelSet set{thingsOf(scene, file), importCamera(scene, isGltf(file)), sunOf(scene)};
    if (set.things.empty()) refuseModel(file, kNoTriangles);
    return set;
}

}  // namespace demolish
