// SPDX-License-Identifier: Apache-2.0
// A mesh, or why there is none, as bytes between two processes of this program. Who reads them trusts
// nothing.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <variant>

#include "sim_cuda/api/model_file.h"

namespace demolish {

/// The sentence of a model that was turned down.
struct ModelRefusal {
    std::string sentence;
};
/// What stands in a model file, as set_text.h writes it.
struct ModelSetText {
    std::string text;
};
using ModelAnswer = std::variant<ImportedModel, ModelRefusal, ModelSetText>;

inline constexpr uint64_t kMostTriangles = uint64_t{1} << 26;  ///< of a model; and so many vertices
inline constexpr uint64_t kMostText = 4096;                    ///< bytes of a name or a sentence
inline constexpr uint64_t kMostSetText = uint64_t{1} << 22;    ///< bytes

/// Not what writeAnswer() writes.
struct BrokenStream : std::runtime_error {
    explicit BrokenStream(const std::string& why) : std::runtime_error(why) {}
};

/// Header (magic, version, kind, counts, contents), text, positions, triangles, corners, materials as they
/// lie in memory, notes, pictures, checksum. `looks_known`: who reads has them from an answer before.
void writeAnswer(const ModelAnswer& answer, const std::function<void(std::span<const uint8_t>)>& write,
                 bool looks_known = false);

/// `fill` fills all that it is given or throws. Arrays grow with what has come, not with what was announced.
/// Throws BrokenStream: another magic or version, counts beyond those above, a wrong checksum, triangles of
/// vertices or materials that are not there, materials of pictures that are not there, pictures that are too
/// large, numbers that are not finite. `known`: looks of an answer before, for one that leaves them out.
ModelAnswer readAnswer(const std::function<void(std::span<uint8_t>)>& fill,
                       const std::shared_ptr<const ModelLooks>& known = {});

}  // namespace demolish
