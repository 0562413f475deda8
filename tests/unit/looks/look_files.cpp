// SPDX-License-Identifier: Apache-2.0
// Formats written out by hand; the PNG by the system's stb.
#include "tests/unit/looks/look_files.h"

#include <stb/stb_image_write.h>

#include <array>
#include <cstring>
#include <sstream>

namespace demolish::test {
namespace {

struct CubeCorner {
    std::array<float, 3> position, normal;
    std::array<float, 2> uv;  ///< v upwards
};

/// Four a side, counter-clockwise seen from outside.
std::vector<CubeCorner> cubeCorners() {
    std::vector<CubeCorner> corners;
    for (size_t axis = 0; axis < 3; ++axis)
        for (const float side : {-0.5f, 0.5f})
            for (const auto& [s, t] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                CubeCorner corner{};
                const auto u = static_cast<float>(side > 0 ? s : t), v = static_cast<float>(side > 0 ? t : s);
                corner.position[axis] = side;
                corner.position[(axis + 1) % 3] = u - 0.5f;
                corner.position[(axis + 2) % 3] = v - 0.5f;
                corner.normal[axis] = 2 * side;
                corner.uv = {u, v};
                corners.push_back(corner);
            }
    return corners;
}

template <class Value>
void put(std::string& bytes, const Value& value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

void pad(std::string& bytes, char with) {
    while (bytes.size() % 4 != 0) bytes += with;
}

std::string view(size_t offset, size_t length) {
    std::ostringstream text;
    text << R"({"buffer":0,"byteOffset":)" << offset << R"(,"byteLength":)" << length << '}';
    return text.str();
}

std::string accessor(int view, int type, int count, const std::string& shape, const std::string& more = "") {
    std::ostringstream text;
    text << R"({"bufferView":)" << view << R"(,"componentType":)" << type << R"(,"count":)" << count
         << R"(,"type":")" << shape << '"' << more << '}';
    return text.str();
}

}  // namespace

std::string pngOf(int width, int height, const std::vector<uint8_t>& texels) {
    std::string png;
    const auto append = [](void* to, void* bytes, int size) {
        static_cast<std::string*>(to)->append(static_cast<const char*>(bytes), static_cast<size_t>(size));
    };
    stbi_write_png_to_func(append, &png, width, height, 4, texels.data(), 4 * width);
    return png;
}

std::string tgaOf(int width, int height, const std::vector<uint8_t>& texels) {
    std::string tga = {0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    for (const int size : {width, height}) {
        tga += static_cast<char>(size & 0xff);
        tga += static_cast<char>(size >> 8);
    }
    tga += static_cast<char>(32);
    tga += static_cast<char>(0x28);  // upper row first
    for (size_t i = 0; i < texels.size(); i += 4)
        for (const size_t k : {2, 1, 0, 3}) tga += static_cast<char>(texels[i + k]);
    return tga;
}

std::vector<uint8_t> fourTexels() {
    return {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
}

std::string cubeObj(const std::string& mtl_file) {
    std::ostringstream text;
    if (!mtl_file.empty()) text << "mtllib " << mtl_file << "\nusemtl skin\n";
    int number = 0;
    for (const CubeCorner& c : cubeCorners()) {
        text << "v " << c.position[0] << ' ' << c.position[1] << ' ' << c.position[2] << "\nvt " << c.uv[0]
             << ' ' << c.uv[1] << '\n';
        if (++number % 4 != 0) continue;
        text << 'f';
        for (int k = number - 3; k <= number; ++k) text << ' ' << k << '/' << k;
        text << '\n';
    }
    return text.str();
}

std::string cubeGlb(const std::string& material, const std::string& picture, bool with_colours,
                    const std::string& textures, float opacity) {
    std::string positions, normals, uvs, second_uvs, colours, indices;
    uint16_t number = 0;
    for (const CubeCorner& c : cubeCorners()) {
        put(positions, c.position);
        put(normals, c.normal);
        put(uvs, std::array<float, 2>{c.uv[0], 1 - c.uv[1]});  // glTF's v runs downwards
        put(second_uvs, std::array<float, 2>{0.5f * c.uv[0], 1 - 0.25f * c.uv[1]});
        put(colours, std::array<float, 4>{0.5f, 0.25f, 1, opacity});
        if (++number % 4 != 0) continue;
        for (const int k : {-4, -3, -2, -4, -2, -1}) put(indices, static_cast<uint16_t>(number + k));
    }
    std::string data, views;
    for (const std::string& part : {positions, normals, uvs, colours, indices, picture, second_uvs}) {
        if (!views.empty()) views += ',';
        views += view(data.size(), part.size());
        data += part;
        pad(data, '\0');
    }
    std::ostringstream text;
    text
        << R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_texture_transform","KHR_materials_pbrSpecularGlossiness"],"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[)"
        << R"({"primitives":[{"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"TEXCOORD_1":5)"
        << (with_colours ? R"(,"COLOR_0":3)" : "") << R"(},"indices":4,"material":0}]}],"materials":[)"
        << material << R"(],"textures":)" << textures
        << R"(,"images":[{"bufferView":5,"mimeType":"image/png"}],)"
        << R"("accessors":[)"
        << accessor(0, 5126, 24, "VEC3", R"(,"min":[-0.5,-0.5,-0.5],"max":[0.5,0.5,0.5])") << ','
        << accessor(1, 5126, 24, "VEC3") << ',' << accessor(2, 5126, 24, "VEC2") << ','
        << accessor(3, 5126, 24, "VEC4") << ',' << accessor(4, 5123, 36, "SCALAR") << ','
        << accessor(6, 5126, 24, "VEC2") << R"(],"bufferViews":[)" << views
        << R"(],"buffers":[{"byteLength":)" << data.size() << "}]}";
    std::string json = text.str();
    pad(json, ' ');
    std::string glb = "glTF";
    put(glb, uint32_t{2});
    put(glb, static_cast<uint32_t>(12 + 8 + json.size() + 8 + data.size()));
    put(glb, static_cast<uint32_t>(json.size()));
    glb += "JSON" + json;
    put(glb, static_cast<uint32_t>(data.size()));
    glb += std::string("BIN\0", 4) + data;
    return glb;
}

std::string cubeDae(const std::string& picture) {
    std::ostringstream positions, uvs, faces;
    int number = 0;
    for (const CubeCorner& c : cubeCorners()) {
        for (const float p : c.position) positions << p << ' ';
        uvs << c.uv[0] << ' ' << c.uv[1] << ' ';
        if (++number % 4 != 0) continue;
        for (const int k : {-4, -3, -2, -4, -2, -1}) faces << number + k << ' ';
    }
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_images><image id="pic"><init_from>)" +
           picture + R"(</init_from></image></library_images>
<library_effects><effect id="fx"><profile_COMMON>
<newparam sid="surf"><surface type="2D"><init_from>pic</init_from></surface></newparam>
<newparam sid="samp"><sampler2D><source>surf</source></sampler2D></newparam>
<technique sid="common"><lambert><diffuse><texture texture="samp" texcoord="UV"/></diffuse></lambert></technique>
</profile_COMMON></effect></library_effects>
<library_materials><material id="mat"><instance_effect url="#fx"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="72">)" +
           positions.str() + R"(</float_array><technique_common><accessor source="#pa" count="24" stride="3">
<param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<source id="t"><float_array id="ta" count="48">)" +
           uvs.str() + R"(</float_array><technique_common><accessor source="#ta" count="24" stride="2">
<param name="S" type="float"/><param name="T" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="m" count="12"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#t" offset="0" set="0"/><p>)" +
           faces.str() + R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#mat"><bind_vertex_input semantic="UV" input_semantic="TEXCOORD" input_set="0"/></instance_material>
</technique_common></bind_material></instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

}  // namespace demolish::test
