// SPDX-License-Identifier: Apache-2.0
// The file's JSON is looked through a second time, and only where it names one of them.
#include "sim_cuda/authoring/looks/gltf_left_out.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "sim_cuda/authoring/scene_reading.h"

namespace demolish {
namespace {

using Json = nlohmann::json;

constexpr uint32_t kMostJsonBytes = 1u << 30;

struct PictureExtension {
    const char *name, *format;
};
constexpr PictureExtension kExtensions[] = {{"EXT_texture_webp", "WebP"},
                                            {"EXT_texture_avif", "AVIF"},
                                            {"KHR_texture_basisu", "KTX2"},
                                            {"MSFT_texture_dds", "DDS"}};

/// The whole file, or the first chunk of a binary one; empty where it is neither.
std::string jsonOf(const std::filesystem::path& model) {
    std::ifstream file(model, std::ios::binary);
    std::array<char, 20> head{};
    file.read(head.data(), head.size());
    std::string text;
    if (std::memcmp(head.data(), "glTF", 4) == 0) {
        uint32_t length = 0;
        std::memcpy(&length, head.data() + 12, sizeof length);
        std::error_code error;
        if (!file || length > kMostJsonBytes || length > std::filesystem::file_size(model, error)) return {};
        text.resize(length);
        file.read(text.data(), static_cast<std::streamsize>(length));
        return text;
    }
    file.clear();
    file.seekg(0);
    return {std::istreambuf_iterator<char>(file), {}};
}

constexpr const char* kInstancing = "EXT_mesh_gpu_instancing";

bool namesAny(const std::string& text) {
    return text.find(kInstancing) != std::string::npos || text.find("\"targets\"") != std::string::npos ||
           std::any_of(std::begin(kExtensions), std::end(kExtensions),
                       [&](const auto& one) { return text.find(one.name) != std::string::npos; });
}

const Json& member(const Json& object, const char* name) {
    static const Json kNothing;
    const auto at = object.is_object() ? object.find(name) : object.end();
    return at == object.end() ? kNothing : *at;
}

bool standsForMany(const Json& node) {
    return !member(member(node, "extensions"), kInstancing).is_null();
}

bool morphs(const Json& node) {
    const Json& weights = member(node, "weights");
    return weights.is_array() && std::any_of(weights.begin(), weights.end(), [](const Json& weight) {
               return weight.is_number() && weight.get<double>() != 0;
           });
}

std::string nameOf(const Json& images, const Json& source) {
    if (!source.is_number_unsigned()) return "?";
    const auto number = source.get<size_t>();
    if (!images.is_array() || number >= images.size()) return "?";
    for (const char* key : {"uri", "name"})
        if (const Json& name = member(images[number], key);
            name.is_string() && name.get_ref<const std::string&>().rfind("data:", 0) != 0)
            return name.get<std::string>();
    return "number " + std::to_string(number);
}

}  // namespace

GltfLeftOut gltfLeftOut(const std::filesystem::path& model) {
    if (!isGltf(model)) return {};
    const std::string text = jsonOf(model);
    if (!namesAny(text)) return {};
    const Json file = Json::parse(text, nullptr, false);
    GltfLeftOut left;
    for (const Json& texture : member(file, "textures")) {
        if (!member(texture, "source").is_null()) continue;  // another form of it is there
        for (const auto& [name, format] : kExtensions) {
            const Json& other = member(member(texture, "extensions"), name);
            if (other.is_null()) continue;
            left.pictures.push_back(
                "the texture '" + nameOf(member(file, "images"), member(other, "source")) + "' is " + format +
                ", which is not read (" + name + "): a plain colour instead; export it as PNG or JPEG");
        }
    }
    const Json& nodes = member(file, "nodes");
    if (std::any_of(nodes.begin(), nodes.end(), standsForMany))
        left.nodes.push_back(std::string("nodes that stand for many (") + kInstancing +
                             ") are taken once each; export them one by one");
    if (std::any_of(nodes.begin(), nodes.end(), morphs))
        left.nodes.push_back(
            "weights that nodes give to morph targets are not followed; give them to the meshes");
    return left;
}

}  // namespace demolish
