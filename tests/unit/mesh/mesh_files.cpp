// SPDX-License-Identifier: Apache-2.0
// Text and exported model files for the import tests.
#include "tests/unit/mesh/mesh_files.h"

#include <assimp/scene.h>
#include <unistd.h>

#include <assimp/Exporter.hpp>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>

namespace demolish::test {
namespace {

aiMesh* toAssimp(const TriangleMesh& mesh) {
    auto* out = new aiMesh;
    out->mPrimitiveTypes = aiPrimitiveType_TRIANGLE;
    out->mNumVertices = unsigned(mesh.positions.size());
    out->mVertices = new aiVector3D[out->mNumVertices];
    for (unsigned v = 0; v < out->mNumVertices; ++v) {
        const Double3& p = mesh.positions[v];
        out->mVertices[v] = {float(p.x), float(p.y), float(p.z)};
    }
    out->mNumFaces = unsigned(mesh.triangles.size());
    out->mFaces = new aiFace[out->mNumFaces];
    for (unsigned f = 0; f < out->mNumFaces; ++f) {
        const auto& t = mesh.triangles[f];
        out->mFaces[f].mNumIndices = 3;
        out->mFaces[f].mIndices = new unsigned[3]{t[0], t[1], t[2]};
    }
    return out;
}

std::unique_ptr<aiScene> sceneOf(const TriangleMesh& mesh, bool mirrored) {
    auto scene = std::make_unique<aiScene>();
    scene->mMaterials = new aiMaterial* [1] { new aiMaterial };
    scene->mNumMaterials = 1;
    scene->mMeshes = new aiMesh* [1] { toAssimp(mesh) };
    scene->mNumMeshes = 1;
    auto* child = new aiNode("child");
    child->mNumMeshes = 1;
    child->mMeshes = new unsigned[1]{0};
    child->mTransformation =
        aiMatrix4x4({mirrored ? -2.f : 2.f, 3, 4}, aiQuaternion({0, 0, 1}, 1.5707963f), {5, 6, 7});
    scene->mRootNode = new aiNode("root");
    scene->mRootNode->addChildren(1, &child);
    return scene;
}

}  // namespace

FileTest::FileTest() {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("demolish_" + std::string(info->name()) + "_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
}

FileTest::~FileTest() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
}

std::filesystem::path FileTest::write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
}

std::filesystem::path FileTest::exportMesh(const TriangleMesh& mesh, const std::string& name,
                                           const std::string& format, bool mirrored) const {
    test::exportMesh(mesh, folder_ / name, format, mirrored);
    return folder_ / name;
}

void exportMesh(const TriangleMesh& mesh, const std::filesystem::path& file, const std::string& format,
                bool mirrored) {
    const auto scene = sceneOf(mesh, mirrored);
    Assimp::Exporter exporter;
    if (exporter.Export(scene.get(), format, file.string()) != aiReturn_SUCCESS)
        throw std::runtime_error(exporter.GetErrorString());
}

std::string objText(const TriangleMesh& mesh, size_t skip) {
    std::ostringstream text;
    text.precision(9);
    for (const Double3& p : mesh.positions) text << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    for (size_t i = skip; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        text << "f " << t[0] + 1 << ' ' << t[1] + 1 << ' ' << t[2] + 1 << '\n';
    }
    return text.str();
}

}  // namespace demolish::test
