// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/meshes/gltf_set.h"

#include <cstdint>
#include <fstream>

#include "tests/unit/meshes/mesh_makers.h"

namespace demolish::test {
namespace {

template <class Value>
void put(std::ofstream& out, Value value) {
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

std::filesystem::path writeGltfSet(const std::filesystem::path& folder, const std::string& name,
                                   const std::string& nodes, const std::string& scene,
                                   const std::string& more, const std::vector<GltfNumbers>& numbers) {
    const TriangleMesh cube = makeCube(1);
    Double3 low = cube.positions[0];
    for (const Double3& p : cube.positions)
        if (p.x + p.y + p.z < low.x + low.y + low.z) low = p;
    std::ofstream bytes(folder / "box.bin", std::ios::binary);
    for (const Double3& p : cube.positions)
        for (const double v : {p.x - low.x - 0.5, p.y - low.y - 0.5, p.z - low.z - 0.5})
            put(bytes, static_cast<float>(v));
    for (const auto& triangle : cube.triangles)
        for (const uint32_t vertex : triangle) put(bytes, static_cast<uint16_t>(vertex));
    std::string views, accessors;
    size_t at = 168;
    for (const GltfNumbers& list : numbers) {
        const size_t each = list.type == "SCALAR" ? 1 : list.type == "VEC3" ? 3 : 4;
        for (const float value : list.values) put(bytes, value);
        const std::string view = std::to_string(2 + (&list - numbers.data())),
                          bytes_of_list = std::to_string(4 * list.values.size());
        views +=
            ",{\"buffer\":0,\"byteOffset\":" + std::to_string(at) + ",\"byteLength\":" + bytes_of_list + "}";
        accessors += ",{\"bufferView\":" + view +
                     ",\"componentType\":5126,\"count\":" + std::to_string(list.values.size() / each) +
                     ",\"type\":\"" + list.type + "\"}";
        at += 4 * list.values.size();
    }
    const std::filesystem::path file = folder / name;
    std::ofstream(file) << R"({"asset":{"version":"2.0"},"buffers":[{"uri":"box.bin","byteLength":)" << at
                        << R"(}],
"bufferViews":[{"buffer":0,"byteLength":96},{"buffer":0,"byteOffset":96,"byteLength":72})"
                        << views << R"(],
"accessors":[{"bufferView":0,"componentType":5126,"count":8,"type":"VEC3","min":[-0.5,-0.5,-0.5],"max":[0.5,0.5,0.5]},
{"bufferView":1,"componentType":5123,"count":36,"type":"SCALAR"})"
                        << accessors << R"(],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"nodes":)"
                        << nodes << R"(,"scenes":[{"nodes":)" << scene << "}],\"scene\":0" << more << "}";
    return file;
}

}  // namespace demolish::test
