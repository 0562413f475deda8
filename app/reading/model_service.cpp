// SPDX-License-Identifier: Apache-2.0
// Limits, import, answer, end.
#include "app/reading/model_service.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

#include "app/reading/mesh_stream.h"
#include "app/reading/reading_limits.h"
#include "app/reading/set_text.h"
#include "sim_cuda/api/errors.h"
#include "sim_cuda/api/model_file.h"

namespace demolish {
namespace {

/// As soon as an allocation fails, since libraries turn bad_alloc into any other word.
[[noreturn]] void endWithoutMemory() {
    _exit(kOutOfMemory);
}

void writeToStdout(std::span<const uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(STDOUT_FILENO, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) _exit(EXIT_FAILURE);
        bytes = bytes.subspan(static_cast<size_t>(written));
    }
}

/// What `read` gives, or why it gives nothing.
template <class Read>
std::vector<ModelAnswer> answersOf(const std::filesystem::path& file, const Read& read) {
    try {
        return read();
    } catch (const Error& error) {
        return {ModelRefusal{error.what()}};
    } catch (const std::exception& error) {
        return {ModelRefusal{"The model '" + file.string() + "' could not be read (" + error.what() + ")."}};
    }
}

template <class Read>
[[noreturn]] void serve(const std::filesystem::path& file, const Read& read) {
    limitThisReader(mostReadingTime(file).computing);
    std::set_new_handler(endWithoutMemory);
    bool is_first = true;
    for (const ModelAnswer& answer : answersOf(file, read))
        writeAnswer(answer, writeToStdout, !std::exchange(is_first, false));
    _exit(EXIT_SUCCESS);  // nothing is worth cleaning up
}

}  // namespace

void serveModel(const std::filesystem::path& file, const std::vector<std::string>& nodes) {
    serve(file, [&] {
        std::vector<ModelAnswer> answers;
        for (ImportedModel& model : importModels(file, nodes)) {
            if (std::max(model.mesh.triangles.size(), model.mesh.positions.size()) > kMostTriangles)
                throw InputFileError("The model '" + file.string() + "' has more than " +
                                     std::to_string(kMostTriangles >> 20) +
                                     " million triangles; make it coarser.");
            answers.emplace_back(std::move(model));
        }
        return answers;
    });
}

void serveSet(const std::filesystem::path& file) {
    serve(file, [&] { return std::vector<ModelAnswer>{ModelSetText{setText(importSet(file))}}; });
}

}  // namespace demolish
