// SPDX-License-Identifier: Apache-2.0
// Model files, which are untrusted input, read in a process of their own.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim_cuda/api/model_file.h"
#include "sim_cuda/api/model_set.h"

namespace demolish {

/// The program that reads model files from now on, started anew for each file; it must answer as
/// model_service.h says. Empty, as at first: this process reads them itself, and a damaged file may end it.
/// Said once, at the start of the program.
void setModelReader(const std::string& program);

/// As importModel(). Whatever the file does to its reader (crash, hunger for memory, endless computing, a
/// wrong answer) is an InputFileError of one sentence that names the file. Asks `progress` now and then, with
/// fraction 0; kills the reader and throws Cancelled when it says so. Throws DeviceError when no reader can
/// be started.
ImportedModel readModel(const std::filesystem::path& file, const std::string& node = {},
                        const ProgressCallback& progress = {});

/// The same of several nodes of the file, which is read once for all of them; they share their looks.
std::vector<ImportedModel> readModels(const std::filesystem::path& file,
                                      const std::vector<std::string>& nodes,
                                      const ProgressCallback& progress = {});
/// As importSet(), by a reader as readModel().
ModelSet readModelSet(const std::filesystem::path& file);

/// readModel() and makeSolidMesh().
std::shared_ptr<const SolidMesh> readSolidMesh(const std::filesystem::path& file,
                                               const MeshPlacement& placement,
                                               const ProgressCallback& progress = {});

}  // namespace demolish
