// SPDX-License-Identifier: Apache-2.0
#include "sim_cuda/authoring/scene_reading.h"

#include <assimp/postprocess.h>

#include <cctype>
#include <string>
#include <system_error>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/authoring/binary_ply.h"
#include "sim_cuda/authoring/model_refusal.h"
#include "sim_cuda/authoring/rest_pose.h"

namespace demolish {
namespace {

/// What assimp said, as one line without a closing full stop.
std::string reasonOf(const Assimp::Importer& importer) {
    std::string reason = importer.GetErrorString();
    if (const size_t end = reason.find('\n'); end != std::string::npos) reason.resize(end);
    while (!reason.empty() && (reason.back() == '.' || reason.back() == ' ')) reason.pop_back();
    return reason.empty() ? "it holds no scene" : reason;
}

/// Devices and pipes may have no end.
void requirePlainFile(const std::filesystem::path& file) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) return;
    if (std::filesystem::is_directory(file, error)) refuseModel(file, "is a folder; name a file in it");
    if (std::filesystem::exists(file, error)) refuseModel(file, "is not a plain file; copy it into one");
    throw InputFileError("There is no model file '" + file.string() + "'; check the path.");
}

std::string lowerEnding(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending;
}

const aiScene* read(Assimp::Importer& importer, const std::filesystem::path& file) {
    constexpr unsigned kSteps = aiProcess_Triangulate | aiProcess_SortByPType | aiProcess_GlobalScale;
    if (const auto bytes = plyWithOneMore(file))
        return importer.ReadFileFromMemory(bytes->data(), bytes->size(), kSteps, "ply");
    return importer.ReadFile(file.string(), kSteps);
}

}  // namespace

/// Those that assimp knows; aiProcess_GlobalScale then makes metres of it.
bool saysItsUnit(const std::filesystem::path& file) {
    const std::string ending = lowerEnding(file);
    return ending == ".gltf" || ending == ".glb" || ending == ".fbx" || ending == ".dae";
}

bool isGltf(const std::filesystem::path& file) {
    const std::string ending = lowerEnding(file);
    return ending == ".gltf" || ending == ".glb";
}

const aiScene& readScene(Assimp::Importer& importer, const std::filesystem::path& file) {
    requirePlainFile(file);
    const aiScene* scene = read(importer, file);
    if (!scene || !scene->mRootNode)
        refuseModel(file, "could not be read (" + reasonOf(importer) +
                              "); use a format such as OBJ, PLY, STL, glTF or FBX");
    if (isGltf(file)) poseAtRest(const_cast<aiScene&>(*scene));  // the importer's own, which is not const
    return *scene;
}

}  // namespace demolish
