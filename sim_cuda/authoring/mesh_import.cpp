// SPDX-License-Identifier: Apache-2.0
// Reads model files with assimp and turns them into one welded mesh.
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cmath>
#include <limits>
#include <set>
#include <unordered_map>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/double3.h"
#include "sim_cuda/authoring/looks/material_import.h"
#include "sim_cuda/authoring/model_nodes.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/node_transform.h"
#include "sim_cuda/authoring/scene_reading.h"
#include "sim_cuda/authoring/unused_vertices.h"

namespace demolish {
namespace {

struct PositionHash {
    size_t operator()(const std::array<uint64_t, 3>& bits) const {
        uint64_t h = 0;
        for (const uint64_t b : bits) h = (h ^ (b >> 29) ^ b) * 0x9e3779b97f4a7c15ull;
        return size_t(h ^ (h >> 32));
    }
};

/// Gathers triangles and gives equal positions one id, in order of first use.
class Welder {
  public:
    explicit Welder(std::string name) { mesh_.name = std::move(name); }

    void add(const std::array<Double3, 3>& points, const std::array<CornerAttributes, 3>& corners) {
        ++triangles_seen_;
        const std::array<uint32_t, 3> ids{idOf(points[0]), idOf(points[1]), idOf(points[2])};
        if (ids[0] == ids[1] || ids[1] == ids[2] || ids[2] == ids[0]) return;
        mesh_.triangles.push_back(ids);
        mesh_.corners.push_back(corners);
    }
    size_t trianglesSeen() const { return triangles_seen_; }
    /// As ModelContents; of a mesh under this transform.
    void noteCoarseness(const aiMesh& mesh, const NodeTransform& transform) {
        float farthest = 0;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v)
            for (int k = 0; k < 3; ++k) farthest = std::max(farthest, std::abs(float(mesh.mVertices[v][k])));
        if (!std::isfinite(farthest)) return;
        const double stretch = std::max({length(transform.x), length(transform.y), length(transform.z)});
        const float next = std::nextafter(farthest, std::numeric_limits<float>::infinity());
        coarseness_ = std::max(coarseness_, float(stretch * double(next - farthest)));
    }
    float coarseness() const { return coarseness_; }
    TriangleMesh take() && { return std::move(mesh_); }

  private:
    uint32_t idOf(const Double3& p) {
        const auto bits = [](double v) {
            return std::bit_cast<uint64_t>(v + 0.0);
        };  // -0 and 0 are one place
        const auto [it, is_new] =
            ids_.try_emplace({bits(p.x), bits(p.y), bits(p.z)}, uint32_t(mesh_.positions.size()));
        if (is_new) mesh_.positions.push_back(p);
        return it->second;
    }

    TriangleMesh mesh_;
    std::unordered_map<std::array<uint64_t, 3>, uint32_t, PositionHash> ids_;
    size_t triangles_seen_ = 0;
    float coarseness_ = 0;
};

Float3 toFloat(const Double3& v) {
    return {float(v.x), float(v.y), float(v.z)};
}
/// Unit normal of the corner, or `fallback` where the file gives none that can be used.
Float3 cornerNormal(const aiMesh& mesh, unsigned vertex, const NodeTransform& transform,
                    const Double3& fallback) {
    if (!mesh.HasNormals()) return toFloat(fallback);
    const Double3 n = transform.normal(fromAssimp(mesh.mNormals[vertex]));
    return isFinite(n) && lengthSquared(n) > 0 ? toFloat(n) : toFloat(fallback);
}

Float2 cornerUv(const aiMesh& mesh, unsigned set, unsigned vertex, const UvTransform& laid) {
    if (!mesh.HasTextureCoords(set)) return {};
    const aiVector3D& uv = mesh.mTextureCoords[set][vertex];
    return std::isfinite(uv.x) && std::isfinite(uv.y) ? laid({float(uv.x), float(uv.y)}) : Float2{};
}

/// sRGB of 8 bits. glTF's colours are linear, those of others are meant for the screen.
uint32_t cornerColour(const aiMesh& mesh, unsigned vertex, bool are_linear, bool has_alpha) {
    if (!mesh.HasVertexColors(0)) return kWhite;
    const aiColor4D& c = mesh.mColors[0][vertex];
    uint32_t packed = 0;
    for (int k = 0; k < 4; ++k) {
        float value = std::isfinite(c[k]) ? std::clamp(float(c[k]), 0.0f, 1.0f) : 1.0f;
        if (are_linear && k < 3)
            value = value <= 0.0031308f ? 12.92f * value : 1.055f * std::pow(value, 1 / 2.4f) - 0.055f;
        packed |= uint32_t(std::lround(255 * value)) << 8 * k;
    }
    return has_alpha ? packed : packed | 0xff000000u;
}

/// Of colours without opacity assimp leaves it at 0.
bool hasAlpha(const aiMesh& mesh) {
    const aiColor4D* colours = mesh.mColors[0];
    return mesh.HasVertexColors(0) &&
           std::any_of(colours, colours + mesh.mNumVertices, [](const aiColor4D& c) { return c.a != 0; });
}

/// What is the same for all meshes of a file.
struct FileFacts {
    const std::filesystem::path& file;
    const std::vector<std::array<UvTransform, 2>>& uv_transforms;  ///< by material; none: looks do not matter
    bool linear_colours = false;
};

void addMesh(Welder& welder, const aiMesh& mesh, const NodeTransform& transform, const FileFacts& facts) {
    const std::filesystem::path& file = facts.file;
    const bool has_looks = mesh.mMaterialIndex < facts.uv_transforms.size();
    const auto laid = has_looks ? facts.uv_transforms[mesh.mMaterialIndex] : std::array<UvTransform, 2>{};
    const bool has_alpha = has_looks && hasAlpha(mesh);
    const bool mirrored = transform.determinant() < 0;
    welder.noteCoarseness(mesh, transform);
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) continue;  // points and lines
        const unsigned ids[3] = {face.mIndices[0], face.mIndices[mirrored ? 2 : 1],
                                 face.mIndices[mirrored ? 1 : 2]};
        std::array<Double3, 3> points;
        for (int k = 0; k < 3; ++k) {
            if (ids[k] >= mesh.mNumVertices) refuseModel(file, kNoSuchVertex);
            points[k] = transform.point(fromAssimp(mesh.mVertices[ids[k]]));
            if (!isFinite(points[k])) refuseModel(file, kEndlessNumber);
        }
        const Double3 flat = normalized(cross(points[1] - points[0], points[2] - points[0]));
        if (!isFinite(flat)) refuseModel(file, "is too large to be a body; export it in a smaller unit");
        std::array<CornerAttributes, 3> corners;
        for (int k = 0; k < 3; ++k) {
            corners[k] = {cornerNormal(mesh, ids[k], transform, flat), cornerUv(mesh, 0, ids[k], laid[0])};
            if (!has_looks) continue;
            corners[k].second_uv = cornerUv(mesh, 1, ids[k], laid[1]);
            corners[k].colour = cornerColour(mesh, ids[k], facts.linear_colours, has_alpha);
            corners[k].material = mesh.mMaterialIndex;
        }
        welder.add(points, corners);
    }
}

void addOwn(Welder& welder, const aiScene& scene, const aiNode& node, const NodeTransform& transform,
            const FileFacts& facts) {
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
        if (node.mMeshes[i] >= scene.mNumMeshes) refuseModel(facts.file, kNoSuchPart);
        addMesh(welder, *scene.mMeshes[node.mMeshes[i]], transform, facts);
    }
}

void addAll(Welder& welder, const aiScene& scene, const aiNode& node, const NodeTransform& transform,
            const FileFacts& facts) {
    addOwn(welder, scene, node, transform, facts);
    for (unsigned i = 0; i < node.mNumChildren; ++i)
        addAll(welder, scene, *node.mChildren[i], chained(transform, node.mChildren[i]->mTransformation),
               facts);
}

void addPart(Welder& welder, const aiScene& scene, const std::string& node, const FileFacts& facts) {
    const aiNode& root = *scene.mRootNode;
    const aiNode& part = node.empty() ? root : requireNode(root, node, facts.file);
    const bool has_own = !node.empty() && part.mNumMeshes > 0;
    (has_own ? addOwn : addAll)(welder, scene, part, placeOf(part), facts);
}

/// assimp adds one to files of its own, which no mesh may use.
uint32_t materialCount(const aiScene& scene) {
    std::set<unsigned> used;
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) used.insert(scene.mMeshes[i]->mMaterialIndex);
    return uint32_t(used.size());
}

uint32_t textureCount(const aiScene& scene) {
    std::set<std::string> pictures;
    for (unsigned m = 0; m < scene.mNumMaterials; ++m)
        for (int type = aiTextureType_NONE + 1; type <= AI_TEXTURE_TYPE_MAX; ++type) {
            const auto kind = aiTextureType(type);
            const aiMaterial& material = *scene.mMaterials[m];
            for (unsigned i = 0; i < material.GetTextureCount(kind); ++i) {
                aiString path;
                if (material.GetTexture(kind, i, &path) == aiReturn_SUCCESS) pictures.insert(path.C_Str());
            }
        }
    return uint32_t(pictures.size());
}

}  // namespace

std::vector<ImportedModel> importModels(const std::filesystem::path& file,
                                        const std::vector<std::string>& nodes) {
    Assimp::Importer importer;
    const aiScene& scene = readScene(importer, file);
    const ImportedLooks imported = importLooks(file, scene);
    const FileFacts facts{file, imported.uv_transforms, isGltf(file)};
    ModelContents contents{scene.mNumMeshes, materialCount(scene), textureCount(scene), saysItsUnit(file)};
    std::vector<ImportedModel> models;
    for (const std::string& node : nodes) {
        Welder welder(file.stem().string());
        addPart(welder, scene, node, facts);
        if (welder.trianglesSeen() == 0) refuseModel(file, kNoTriangles);
        contents.coarseness = welder.coarseness();
        models.push_back({std::move(welder).take(), contents, imported.looks});
        dropUnusedVertices(models.back().mesh);  // those of dropped triangles
    }
    return models;
}

ImportedModel importModel(const std::filesystem::path& file, const std::string& node) {
    return std::move(importModels(file, {node}).front());
}

TriangleMesh importTriangles(const std::filesystem::path& file) {
    return importModel(file).mesh;
}

}  // namespace demolish
