// SPDX-License-Identifier: Apache-2.0
// A rabbit of few particles in a state that was once simulated and stored: pictures of a really broken body
// that do not change when the solver does.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include "engine/render/fracture_mesh.h"
#include "sim_cuda/api/breakable_body.h"
#include "sim_cuda/api/render_streams.h"

namespace demolish::engine::test {

inline constexpr uint32_t kRabbitParticles = 200;
inline constexpr float kRabbitHeight = 0.348f;  // m

/// What a picture needs of a simulated moment.
struct RabbitState {
    std::vector<uint32_t> slot;                       ///< of each particle
    std::map<uint32_t, FragmentTransform> transform;  ///< of each slot in use
    std::vector<CrackLine> cracks;                    ///< those shown
};

/// Text: the slots, then a line for each slot's motion, then the cracks, edge and widths. Throws
/// std::runtime_error if unreadable.
RabbitState readState(const std::filesystem::path& file);
void writeState(const std::filesystem::path& file, const RabbitState& state);
/// Stored states: "cracked" (a light hit) and "broken" (a hard one).
std::filesystem::path stateFile(const std::string& name);

/// Whole and at rest.
RabbitState wholeState(const BreakableBody& body);

/// The same cells on every machine; made once a program.
const std::shared_ptr<const BreakableBody>& rabbitBody();

/// Buffers with the state in them; the context must be current. Broken faces are as they were cut, without
/// smoothing.
FractureMesh makeRabbitMesh(const BreakableBody& body, const RabbitState& state);

}  // namespace demolish::engine::test
