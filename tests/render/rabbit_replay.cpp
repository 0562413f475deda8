// SPDX-License-Identifier: Apache-2.0
// The draw lists are made from the cells' faces here, so that a picture depends on cells and stored motions
// alone.
#include "tests/render/rabbit_replay.h"

#include <fstream>
#include <glm/glm.hpp>
#include <span>
#include <stdexcept>

#include "sim_cuda/api/authoring.h"
#include "sim_cuda/physics/vertex_packing.h"

namespace demolish::engine::test {
namespace {

glm::vec3 toGlm(const Float3& v) {
    return {v.x, v.y, v.z};
}

struct DrawList {
    std::vector<SurfaceVertex> vertices;
    std::vector<uint32_t> indices;
};

/// Both sides of a face between two fragments; flat, with one normal.
void appendFace(const FractureGeometry& geometry, const InteriorFace& face, DrawList& list) {
    const auto position = [&](uint32_t local) {
        return geometry.pool[geometry.face_vertices[face.first_vertex + local]];
    };
    const std::span<const uint16_t> corners(geometry.face_indices.data() + face.first_index,
                                            face.index_count);
    glm::vec3 area(0);
    for (size_t k = 0; k + 2 < corners.size(); k += 3) {
        const glm::vec3 a = toGlm(position(corners[k]));
        area += glm::cross(toGlm(position(corners[k + 1])) - a, toGlm(position(corners[k + 2])) - a);
    }
    if (glm::length(area) <= 0) return;
    const glm::vec3 outward = glm::normalize(area);
    for (const bool side_a : {true, false}) {
        const auto first = static_cast<uint32_t>(list.vertices.size());
        const glm::vec3 n = side_a ? outward : -outward;
        for (uint32_t k = 0; k < face.vertex_count; ++k)
            list.vertices.push_back(
                {position(k), packOctahedral(n.x, n.y, n.z), 0, side_a ? face.cell_a : face.cell_b});
        for (size_t k = 0; k + 2 < corners.size(); k += 3) {
            const uint32_t second = first + corners[side_a ? k + 1 : k + 2];
            const uint32_t third = first + corners[side_a ? k + 2 : k + 1];
            list.indices.insert(list.indices.end(), {first + corners[k], second, third});
        }
    }
}

DrawList exposedFaces(const FractureGeometry& geometry, const RabbitState& state) {
    DrawList list;
    for (const InteriorFace& face : geometry.faces) {
        if (state.slot[face.cell_a] != state.slot[face.cell_b]) appendFace(geometry, face, list);
    }
    return list;
}

template <class T>
void upload(FractureMesh& mesh, StreamId id, const std::vector<T>& values) {
    if (!values.empty()) mesh.stream(id).upload(std::as_bytes(std::span(values)));
}

}  // namespace

RabbitState readState(const std::filesystem::path& file) {
    std::ifstream in(file);
    RabbitState state;
    size_t particles = 0, slots = 0, cracks = 0;
    in >> particles >> slots >> cracks;
    state.slot.resize(particles);
    for (uint32_t& slot : state.slot) in >> slot;
    for (size_t k = 0; k < slots; ++k) {
        uint32_t slot = 0;
        FragmentTransform t;
        in >> slot >> t.rotation.x >> t.rotation.y >> t.rotation.z >> t.rotation.w >> t.translation.x >>
            t.translation.y >> t.translation.z;
        state.transform[slot] = t;
    }
    state.cracks.resize(cracks);
    for (CrackLine& crack : state.cracks) in >> crack.edge >> crack.widths;
    if (!in || particles == 0) throw std::runtime_error("Not a stored state: " + file.string());
    return state;
}

void writeState(const std::filesystem::path& file, const RabbitState& state) {
    std::ofstream out(file);
    out.precision(9);
    out << state.slot.size() << ' ' << state.transform.size() << ' ' << state.cracks.size() << '\n';
    const auto writeRow = [&](const std::vector<uint32_t>& values) {
        for (size_t k = 0; k < values.size(); ++k)
            out << values[k] << (k % 20 == 19 || k + 1 == values.size() ? '\n' : ' ');
    };
    writeRow(state.slot);
    for (const auto& [slot, t] : state.transform) {
        const Float4& q = t.rotation;
        out << slot << ' ' << q.x << ' ' << q.y << ' ' << q.z << ' ' << q.w << ' ' << t.translation.x << ' '
            << t.translation.y << ' ' << t.translation.z << '\n';
    }
    std::vector<uint32_t> cracks;
    for (const CrackLine& crack : state.cracks) cracks.insert(cracks.end(), {crack.edge, crack.widths});
    writeRow(cracks);
}

std::filesystem::path stateFile(const std::string& name) {
    return std::filesystem::path(DEMOLISH_SOURCE_DIR) / "tests/render/data" / ("rabbit_" + name + ".txt");
}

RabbitState wholeState(const BreakableBody& body) {
    RabbitState state;
    state.slot.assign(body.particles.size(), 0);
    state.transform[0] = {};
    return state;
}

const std::shared_ptr<const BreakableBody>& rabbitBody() {
    static const std::shared_ptr<const BreakableBody> body = [] {
        const auto file = std::filesystem::path(DEMOLISH_SOURCE_DIR) / "assets/models/rabbit_paper.obj";
        return fillWithParticles(*loadSolidMesh(file, {.height = kRabbitHeight}),
                                 {.particles = kRabbitParticles});
    }();
    return body;
}

FractureMesh makeRabbitMesh(const BreakableBody& body, const RabbitState& state) {
    const FractureGeometry& geometry = body.geometry;
    const DrawList broken = exposedFaces(geometry, state);
    FractureMeshData data;
    data.exterior_vertices = std::as_bytes(std::span(geometry.exterior));
    data.exterior_indices = geometry.exterior_indices;
    data.crack_edges = std::as_bytes(std::span(geometry.crack_edges));
    data.particle_count = data.particle_capacity = body.particles.size();
    data.interior_vertex_capacity = broken.vertices.size();
    data.interior_index_capacity = broken.indices.size();
    data.crack_capacity = state.cracks.size();
    FractureMesh mesh(data);
    std::vector<FragmentTransform> transforms(body.particles.size());
    for (const auto& [slot, transform] : state.transform) transforms.at(slot) = transform;
    DrawCommands commands{};
    commands.interior = {static_cast<uint32_t>(broken.indices.size()), 1, 0, 0, 0};
    commands.cracks = {6, static_cast<uint32_t>(state.cracks.size()), 0, 0, 0};
    commands.exterior = {static_cast<uint32_t>(geometry.exterior_indices.size()), 1, 0, 0, 0};
    upload(mesh, StreamId::kParticleFragment, state.slot);
    upload(mesh, StreamId::kTransforms, transforms);
    upload(mesh, StreamId::kInteriorVertices, broken.vertices);
    upload(mesh, StreamId::kInteriorIndices, broken.indices);
    upload(mesh, StreamId::kCrackEdges, state.cracks);
    upload(mesh, StreamId::kCommands, std::vector<DrawCommands>{commands});
    return mesh;
}

}  // namespace demolish::engine::test
