// SPDX-License-Identifier: Apache-2.0
#include "app/session/scene_node_box.h"

#include <vector>

#include "app/reading/model_reader.h"
#include "app/session/asset_files.h"
#include "app/session/scene_assets.h"
#include "app/session/scene_shapes.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_geometry.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr Range kScaleRange{1e-6, 1e6};
constexpr double kThinnest = 1e-3;  // m, of a box that holds something

struct Extent {
    glm::dvec3 low, high;
    glm::dvec3 size() const { return high - low; }
    glm::dvec3 middle() const { return 0.5 * (low + high); }
};

/// y up.
Extent extentOf(const TriangleMesh& mesh, UpAxis up) {
    Extent extent{glm::dvec3(1e300), glm::dvec3(-1e300)};
    for (const Double3& p : mesh.positions) {
        const glm::dvec3 at = up == UpAxis::kY ? toGlm(p) : glm::dvec3(p.x, p.z, -p.y);
        extent.low = glm::min(extent.low, at);
        extent.high = glm::max(extent.high, at);
    }
    return extent;
}

std::vector<Extent> readExtents(TomlReader& reader, const std::string& key, const std::filesystem::path& file,
                                const std::vector<std::string>& nodes, UpAxis up) {
    try {
        std::vector<Extent> extents;
        for (const ImportedModel& model : readModels(file, nodes))
            extents.push_back(extentOf(model.mesh, up));
        return extents;
    } catch (const InputFileError& error) {
        reader.fail(key, std::string("is wrong: ") + error.what());
    }
}

Box boxOf(const Extent& extent, double scale) {
    return {fromGlm(glm::max(scale * extent.size(), glm::dvec3(kThinnest))),
            fromGlm(scale * extent.middle()),
            {}};
}

}  // namespace

PlacedNode readPlacedNode(TomlReader& reader, const std::string& at, const std::filesystem::path& usual) {
    PlacedNode placed;
    placed.file = usual;
    std::string model;
    reader.read(at + "model", model);
    if (!model.empty()) placed.file = modelFileOf(reader.file(), model);
    if (placed.file.empty()) reader.fail(at + "model", "is missing");
    readPart(reader, at, placed.file, placed.part);
    reader.read(at + "scale", placed.scale, kScaleRange);
    if (placed.part.unit > 0) placed.scale *= placed.part.unit;
    reader.read(at + "position_m", placed.position, kPlaceRange);
    placed.rotation = readTurn(reader, at);
    return placed;
}

Box readNodeBox(TomlReader& reader, const std::string& at, const std::filesystem::path& usual) {
    requireKey(reader, at + "node");
    const PlacedNode node = readPlacedNode(reader, at, usual);
    const Extent extent = readExtents(reader, at + "node", node.file, {node.part.node}, node.part.up).front();
    Box box = boxOf(extent, node.scale);
    const glm::dquat turn(node.rotation.w, node.rotation.x, node.rotation.y, node.rotation.z);
    box.position = fromGlm(toGlm(node.position) + turn * toGlm(box.position));
    box.rotation = node.rotation;
    return box;
}

Box readOwnNodeBox(TomlReader& reader, const std::string& at, const Shot& shot, const SceneBody& body) {
    requireKey(reader, at + "node");
    std::string node;
    reader.read(at + "node", node);
    const MeshPlacement placement = placementOf(shot, body);
    const std::vector<Extent> extents = readExtents(reader, at + "node", body.model.value_or(shot.model),
                                                    {placement.part.node, node}, placement.part.up);
    const Extent& whole = extents[0];
    const glm::dvec3 foot(whole.middle().x, whole.low.y, whole.middle().z);
    const Extent node_of_body{extents[1].low - foot, extents[1].high - foot};
    return boxOf(node_of_body, placementScale(fromGlm(whole.size()), placement));
}

}  // namespace demolish
