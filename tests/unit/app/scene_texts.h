// SPDX-License-Identifier: Apache-2.0
// Scene files as texts.
#pragma once
#include <string>

#include "app/session/scene_file.h"
#include "sim_cuda/api/errors.h"
#include "tests/unit/app/temporary_folder.h"

namespace demolish::test {

/// What every scene file begins with.
inline const std::string kHead = "version = 1\nmodel = \"models/block.obj\"\n";

/// The sentence of the error that reading this text ends in; empty: it is read.
inline std::string complaintAbout(const std::string& text) {
    const TemporaryFolder folder;
    try {
        loadSceneFile(folder.write("scene.toml", text));
    } catch (const InputFileError& error) {
        return error.what();
    }
    return "";
}

}  // namespace demolish::test
