// SPDX-License-Identifier: Apache-2.0
// Writes model files for the import tests into a folder of their own.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "sim_cuda/api/triangle_mesh.h"

struct aiScene;

namespace demolish::test {

/// A fresh folder for each test, removed afterwards.
class FileTest : public ::testing::Test {
  protected:
    FileTest();
    ~FileTest() override;
    const std::filesystem::path& folder() const { return folder_; }
    std::filesystem::path write(const std::string& name, const std::string& text) const;
    /// test::exportMesh() into the folder.
    std::filesystem::path exportMesh(const TriangleMesh& mesh, const std::string& name,
                                     const std::string& format, bool mirrored = false) const;

  private:
    std::filesystem::path folder_;
};

/// The mesh as assimp's exporter writes it, in one of its formats ("ply", "glb2"), under a node that moves,
/// turns and stretches it, or mirrors it. Throws std::runtime_error.
void exportMesh(const TriangleMesh& mesh, const std::filesystem::path& file, const std::string& format,
                bool mirrored = false);

/// Wavefront text; triangles[i] is left out when i < skip.
std::string objText(const TriangleMesh& mesh, size_t skip = 0);

}  // namespace demolish::test
