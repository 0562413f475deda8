// SPDX-License-Identifier: Apache-2.0
// What of a model file is meant, how it lies in it, and how long its lengths are.
#pragma once
#include <string>

namespace demolish {

/// The axis of a file that points up: y in film and games, z in CAD and printing. Few formats say it.
enum class UpAxis { kY, kZ };

struct ModelPart {
    /// Name of a node: its own triangles, or those of all nodes below it where it has none. Of nodes that
    /// share a name the second is `NAME#2` and so on; one without a name is called `node`. Empty: the whole
    /// file.
    std::string node;
    UpAxis up = UpAxis::kY;
    double unit = 0;  ///< m, a length of 1 in a file whose format does not say it; 0: not known

    bool operator==(const ModelPart&) const = default;
};

}  // namespace demolish
