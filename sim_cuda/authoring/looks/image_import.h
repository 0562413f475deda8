// SPDX-License-Identifier: Apache-2.0
// The pictures that a model file names: found, read and decoded, each once.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "sim_cuda/api/model_looks.h"

struct aiScene;

namespace demolish {

class ImageImport {
  public:
    /// The arguments must outlive this.
    ImageImport(const std::filesystem::path& model, const aiScene& scene) : model_(model), scene_(scene) {}

    /// Number of the picture; kNoImage, and a note, where it is missing, damaged or too large. `name` as the
    /// model file has it: of an embedded picture, or a path.
    uint32_t imageOf(const std::string& name);

    const LookImage& at(uint32_t image) const { return images_[image]; }
    std::vector<LookImage> takeImages() { return std::move(images_); }
    std::vector<std::string> takeNotes() { return std::move(notes_); }
    void note(const std::string& text) { notes_.push_back(text); }

  private:
    uint32_t load(const std::string& name);
    std::string decode(const std::vector<uint8_t>& bytes);
    std::string takeTexels(uint32_t width, uint32_t height, std::vector<uint8_t> texels);
    std::string whyTooLarge(uint64_t width, uint64_t height) const;

    const std::filesystem::path& model_;
    const aiScene& scene_;
    std::map<std::string, uint32_t> known_;
    std::vector<LookImage> images_;
    std::vector<std::string> notes_;
    uint64_t bytes_ = 0;  ///< of all
};

}  // namespace demolish
