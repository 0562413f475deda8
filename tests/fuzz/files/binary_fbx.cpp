// SPDX-License-Identifier: Apache-2.0
// Nodes of properties and nodes, each with the offset of its end.
#include "tests/fuzz/files/binary_fbx.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace demolish::fuzz {
namespace {

template <class T>
std::string bytesOf(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}

/// One property: its type, then its bytes.
std::string property(char type, const std::string& bytes) {
    std::string all(1, type);
    all += bytes;
    return all;
}
std::string number(int32_t value) {
    return property('I', bytesOf(value));
}
std::string number(int64_t value) {
    return property('L', bytesOf(value));
}
std::string text(std::string_view value) {
    return property('S', bytesOf(static_cast<uint32_t>(value.size())).append(value));
}
/// Elements, 0 for not compressed, length in bytes, bytes.
template <class T>
std::string list(char type, const std::vector<T>& values) {
    const auto length = static_cast<uint32_t>(values.size() * sizeof(T));
    std::string bytes = bytesOf(static_cast<uint32_t>(values.size()));
    bytes += bytesOf(0u);
    bytes += bytesOf(length);
    for (const T& value : values) bytes += bytesOf(value);
    return property(type, bytes);
}

struct Node {
    std::string name;
    std::vector<std::string> properties;
    std::vector<Node> children{};
};

const std::string kEndOfNodes(13, '\0');

void append(const Node& node, std::string& file) {
    const size_t begin = file.size();
    uint32_t length = 0;
    for (const auto& property : node.properties) length += static_cast<uint32_t>(property.size());
    file += bytesOf(0u) + bytesOf(static_cast<uint32_t>(node.properties.size())) + bytesOf(length);
    file += static_cast<char>(node.name.size());
    file += node.name;
    for (const auto& property : node.properties) file += property;
    for (const Node& child : node.children) append(child, file);
    if (!node.children.empty()) file += kEndOfNodes;
    file.replace(begin, 4, bytesOf(static_cast<uint32_t>(file.size())));
}

Node geometryOf(const TriangleMesh& mesh, int64_t id) {
    std::vector<double> vertices;
    for (const Double3& p : mesh.positions) vertices.insert(vertices.end(), {p.x, p.y, p.z});
    std::vector<int32_t> corners;  // the last one of a polygon is its complement
    for (const auto& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const auto corner = static_cast<int32_t>(t[k]);
            corners.push_back(k == 2 ? ~corner : corner);
        }
    using namespace std::string_view_literals;
    return {"Geometry",
            {number(id), text("body\0\1Geometry"sv), text("Mesh")},
            {{"Vertices", {list('d', vertices)}}, {"PolygonVertexIndex", {list('i', corners)}}}};
}

}  // namespace

std::string binaryFbx(const TriangleMesh& mesh) {
    using namespace std::string_view_literals;
    constexpr int64_t kGeometry = 1000, kModel = 2000, kRoot = 0;
    const Node model{"Model",
                     {number(kModel), text("body\0\1Model"sv), text("Mesh")},
                     {{"Version", {number(int32_t{232})}}}};
    const std::vector<Node> nodes = {{"FBXHeaderExtension", {}, {{"FBXVersion", {number(int32_t{7400})}}}},
                                     {"Objects", {}, {geometryOf(mesh, kGeometry), model}},
                                     {"Connections",
                                      {},
                                      {{"C", {text("OO"), number(kGeometry), number(kModel)}},
                                       {"C", {text("OO"), number(kModel), number(kRoot)}}}}};
    std::string file("Kaydara FBX Binary  \0\x1a\0"sv);
    file += bytesOf(7400u);
    for (const Node& node : nodes) append(node, file);
    return file + kEndOfNodes;
}

}  // namespace demolish::fuzz
