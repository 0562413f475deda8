// SPDX-License-Identifier: Apache-2.0
// Lines word by word; the name is what follows the last option, spaces and all.
#include "sim_cuda/authoring/looks/mtl_options.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>

namespace demolish {
namespace {

namespace fs = std::filesystem;

std::string lowered(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

std::string trimmed(const std::string& text) {
    const size_t begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
    return begin == std::string::npos ? "" : text.substr(begin, end + 1 - begin);
}

/// Takes the first word off.
std::string takeWord(std::string& rest) {
    rest = trimmed(rest);
    const size_t end = std::min(rest.find_first_of(" \t"), rest.size());
    std::string word = rest.substr(0, end);
    rest = trimmed(rest.substr(end));
    return word;
}

std::optional<float> numberOf(const std::string& word) {
    char* end = nullptr;
    const float number = std::strtof(word.c_str(), &end);
    if (word.empty() || *end != '\0' || !std::isfinite(number)) return std::nullopt;
    return number;
}

/// Up to three numbers; what is left out stays. The last word is the picture's name, whatever it is.
void takeNumbers(std::string& rest, float* numbers) {
    for (int k = 0; k < 3; ++k) {
        std::string after = rest;
        const auto number = numberOf(takeWord(after));
        if (!number || after.empty()) return;
        numbers[k] = *number;
        rest = after;
    }
}

std::optional<aiTextureType> typeOf(const std::string& keyword) {
    static const std::map<std::string, aiTextureType> kTypes = {
        {"map_kd", aiTextureType_DIFFUSE},   {"map_ke", aiTextureType_EMISSIVE},
        {"map_d", aiTextureType_OPACITY},    {"map_emissive", aiTextureType_EMISSIVE},
        {"map_bump", aiTextureType_HEIGHT},  {"bump", aiTextureType_HEIGHT},
        {"map_kn", aiTextureType_NORMALS},   {"norm", aiTextureType_NORMALS},
        {"map_pm", aiTextureType_METALNESS}, {"map_pr", aiTextureType_DIFFUSE_ROUGHNESS},
    };
    const auto type = kTypes.find(lowered(keyword));
    return type == kTypes.end() ? std::nullopt : std::optional(type->second);
}

/// Material files of an OBJ; where it names none, the one of its own name.
std::vector<std::string> librariesOf(const fs::path& model) {
    std::vector<std::string> names;
    std::ifstream lines(model);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("mtllib", 0) != 0) continue;
        takeWord(line);
        std::replace(line.begin(), line.end(), '\\', '/');
        names.push_back(line);
    }
    names.push_back(fs::path(model).filename().replace_extension(".mtl").string());
    return names;
}

}  // namespace

MtlPicture mtlPictureOf(const std::string& text) {
    static const std::vector<std::string> kHarmless = {"-blendu", "-blendv", "-boost", "-cc",
                                                       "-clamp",  "-texres", "-type"};
    MtlPicture picture;
    std::string rest = trimmed(text);
    float scale[3] = {1, 1, 1}, offset[3] = {0, 0, 0}, turbulence[3] = {0, 0, 0};
    for (;;) {
        std::string after = rest;
        const std::string option = lowered(takeWord(after));
        if (option == "-s" || option == "-o" || option == "-t") {
            takeNumbers(after, option == "-s" ? scale : option == "-o" ? offset : turbulence);
        } else if (option == "-bm") {
            picture.bump = numberOf(takeWord(after)).value_or(1.0f);
        } else if (option == "-mm" || option == "-imfchan") {
            for (int word = option == "-mm" ? 2 : 1; word > 0; --word) takeWord(after);
            picture.unfollowed.push_back(option);
        } else if (std::find(kHarmless.begin(), kHarmless.end(), option) != kHarmless.end()) {
            takeWord(after);
        } else {
            break;
        }
        rest = after;
    }
    if (turbulence[0] != 0 || turbulence[1] != 0) picture.unfollowed.push_back("-t");
    picture.name = rest;
    picture.laid = {{scale[0], 0, offset[0]}, {0, scale[1], offset[1]}};
    return picture;
}

MtlOptions::MtlOptions(const fs::path& model) {
    if (lowered(model.extension().string()) != ".obj") return;
    for (const std::string& name : librariesOf(model)) readMaterials(model.parent_path() / name);
}

/// The first file that has a material says what it is.
void MtlOptions::readMaterials(const fs::path& file) {
    std::error_code error;
    if (!fs::is_regular_file(file, error)) return;
    std::ifstream lines(file);
    std::string material;
    for (std::string line; std::getline(lines, line);) {
        const std::string keyword = takeWord(line);
        if (lowered(keyword) == "newmtl") material = line;
        const auto type = typeOf(keyword);
        if (!type || line.empty() || line.front() != '-') continue;
        const MtlPicture picture = mtlPictureOf(line);
        if (!picture.name.empty()) pictures_.try_emplace({material, *type}, picture);
    }
}

const MtlPicture* MtlOptions::find(const std::string& material, aiTextureType type) const {
    const auto picture = pictures_.find({material, type});
    return picture == pictures_.end() ? nullptr : &picture->second;
}

bool MtlOptions::names(const std::string& material) const {
    const auto picture = pictures_.lower_bound({material, aiTextureType_NONE});
    return picture != pictures_.end() && picture->first.first == material;
}

}  // namespace demolish
