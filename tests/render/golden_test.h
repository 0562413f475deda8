// SPDX-License-Identifier: Apache-2.0
// How golden pictures are looked up, compared and reported.
#pragma once
#include <filesystem>
#include <string>

#include "engine/image/image.h"

namespace demolish::engine::test {

/// Set by --update-goldens: pictures are accepted instead of compared.
inline bool update_goldens = false;

/// Where the picture of that name is stored for llvmpipe.
std::filesystem::path goldenFile(const std::string& name);

/// Compares with the stored picture of that name, or stores it with --update-goldens.
void expectLooksAsStored(const std::string& name, const Image& picture);

}  // namespace demolish::engine::test
