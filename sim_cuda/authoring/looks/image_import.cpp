// SPDX-License-Identifier: Apache-2.0
// Embedded pictures come from assimp, all are decoded by the system's stb_image.
#include "sim_cuda/authoring/looks/image_import.h"

#include <assimp/scene.h>
#include <stb/stb_image.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>

namespace demolish {
namespace {

namespace fs = std::filesystem;

constexpr uintmax_t kMostFileBytes = uintmax_t{1} << 30;

/// As in addresses: %20 is a space.
std::string withoutPercents(const std::string& text) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                      : -1;
    };
    std::string plain;
    for (size_t i = 0; i < text.size(); ++i) {
        const bool coded =
            text[i] == '%' && i + 2 < text.size() && digit(text[i + 1]) >= 0 && digit(text[i + 2]) >= 0;
        plain += coded ? static_cast<char>(16 * digit(text[i + 1]) + digit(text[i + 2])) : text[i];
        if (coded) i += 2;
    }
    return plain;
}

bool isSameButForCase(const std::string& a, const std::string& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}
/// A plain file whose name differs from that of `place` in upper and lower case alone, as where files are
/// made both are one: the first in the alphabet.
std::optional<fs::path> fileButForCase(const fs::path& place) {
    std::optional<fs::path> found;
    std::error_code error, unread;
    for (fs::directory_iterator entry(place.parent_path(), error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& path = entry->path();
        if (isSameButForCase(path.filename().string(), place.filename().string()) &&
            fs::is_regular_file(path, unread) && (!found || path < *found))
            found = path;
    }
    return found;
}

/// Files carry paths of the machine that they were made on: then the name alone is looked for beside them.
std::vector<fs::path> placesOf(const fs::path& model, const std::string& name) {
    const fs::path folder = model.has_parent_path() ? model.parent_path() : fs::path(".");
    std::vector<fs::path> places;
    for (std::string text : {name, withoutPercents(name)}) {
        std::replace(text.begin(), text.end(), '\\', '/');
        if (text.rfind("file://", 0) == 0) text.erase(0, 7);
        const fs::path path = text, last = path.filename();
        if (last.empty()) continue;
        for (const fs::path& place : {folder / path, folder / last, folder / "textures" / last,
                                      folder.parent_path() / "textures" / last})
            places.push_back(place);
    }
    return places;
}
std::optional<fs::path> placeOf(const fs::path& model, const std::string& name) {
    const std::vector<fs::path> places = placesOf(model, name);
    std::error_code error;
    for (const fs::path& place : places)
        if (fs::is_regular_file(place, error)) return place;
    for (const fs::path& place : places)
        if (const auto found = fileButForCase(place)) return found;
    return std::nullopt;
}

std::optional<std::vector<uint8_t>> contentsOf(const fs::path& file) {
    std::error_code error;
    const uintmax_t size = fs::file_size(file, error);
    if (error || size > kMostFileBytes) return std::nullopt;
    std::vector<uint8_t> bytes(size);
    std::ifstream stream(file, std::ios::binary);
    stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
    if (stream.gcount() != static_cast<std::streamsize>(size)) return std::nullopt;
    return bytes;
}

std::vector<uint8_t> texelsOf(const aiTexture& texture) {
    std::vector<uint8_t> texels;
    const size_t count = size_t{texture.mWidth} * texture.mHeight;
    texels.reserve(4 * count);
    for (size_t i = 0; i < count; ++i) {
        const aiTexel& t = texture.pcData[i];
        texels.insert(texels.end(), {t.r, t.g, t.b, t.a});
    }
    return texels;
}

}  // namespace

uint32_t ImageImport::imageOf(const std::string& name) {
    const auto [place, is_new] = known_.try_emplace(name, kNoImage);
    if (is_new) place->second = load(name);
    return place->second;
}

uint32_t ImageImport::load(const std::string& name) {
    const auto number = static_cast<uint32_t>(images_.size());
    std::string problem;
    if (number >= kMostImages) {
        problem = "is one of more than " + std::to_string(kMostImages);
    } else if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) {
        const auto* bytes = reinterpret_cast<const uint8_t*>(embedded->pcData);
        if (embedded->mHeight == 0)
            problem = decode({bytes, bytes + embedded->mWidth});
        else if (problem = whyTooLarge(embedded->mWidth, embedded->mHeight); problem.empty())
            problem = takeTexels(embedded->mWidth, embedded->mHeight, texelsOf(*embedded));
    } else if (const auto file = placeOf(model_, name)) {
        const auto bytes = contentsOf(*file);
        problem = bytes ? decode(*bytes) : "cannot be read";
    } else {
        problem = "is missing";
    }
    if (problem.empty()) return number;
    note("the texture '" + name + "' " + problem + ": a plain colour instead");
    return kNoImage;
}

std::string ImageImport::whyTooLarge(uint64_t width, uint64_t height) const {
    if (width > kMostImageEdge || height > kMostImageEdge)
        return "has " + std::to_string(width) + " x " + std::to_string(height) + " px, more than " +
               std::to_string(kMostImageEdge) + " along a side";
    if (bytes_ + 4 * width * height > kMostImageBytes)
        return "would make more than " + std::to_string(kMostImageBytes >> 30) + " GiB of textures";
    return {};
}

std::string ImageImport::decode(const std::vector<uint8_t>& bytes) {
    if (bytes.size() > kMostFileBytes) return "is larger than 1 GiB";
    int width = 0, height = 0, channels = 0;
    const int size = static_cast<int>(bytes.size());
    if (stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) == 0)
        return "is damaged, or neither PNG, JPEG nor TGA";
    if (std::string problem = whyTooLarge(static_cast<uint64_t>(width), static_cast<uint64_t>(height));
        !problem.empty())
        return problem;
    const std::unique_ptr<uint8_t, void (*)(void*)> texels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), &stbi_image_free);
    if (texels == nullptr) return "is damaged";
    const size_t count = size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height);
    return takeTexels(static_cast<uint32_t>(width), static_cast<uint32_t>(height),
                      {texels.get(), texels.get() + count});
}

std::string ImageImport::takeTexels(uint32_t width, uint32_t height, std::vector<uint8_t> texels) {
    if (texels.empty()) return "is empty";
    bytes_ += texels.size();
    images_.push_back({width, height, std::move(texels)});
    return {};
}

}  // namespace demolish
