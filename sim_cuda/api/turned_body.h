// SPDX-License-Identifier: Apache-2.0
// A body turned in its own frame: bodies in mortar share the orientation from which their bonds are measured.
#pragma once
#include <memory>

#include "sim_cuda/api/breakable_body.h"

namespace demolish {

/// The same cells, bonds and draw geometry, turned about the frame's origin by a unit quaternion, to the
/// rounding of what each is stored in.
std::shared_ptr<const BreakableBody> turnedBody(const BreakableBody& body, const Quaternion& turn);

}  // namespace demolish
