// SPDX-License-Identifier: Apache-2.0
// Three pictures in one go: a corner is fetched and moved once for all of them.
#include "engine/render/seen_mesh.h"

#include <algorithm>
#include <iterator>

namespace demolish::engine {
namespace {

SampleGrid gridOf(const FrameUniforms& frame, const RenderTargets& targets) {
    const auto& at = targets.sample_position;
    return {frame.view_projection, targets.width, targets.height, {at.begin(), at.begin() + targets.samples}};
}

/// The region's u and v, 0..1, as shaders/shadow.vert puts them onto its part of the map.
SampleGrid shadowGrid(const glm::mat4& light_matrix, int texels) {
    glm::mat4 to_clip = light_matrix;
    for (int column = 0; column < 4; ++column) {
        to_clip[column].x = 2 * light_matrix[column].x - light_matrix[column].w;
        to_clip[column].y = 2 * light_matrix[column].y - light_matrix[column].w;
    }
    return {to_clip, texels, texels};
}

}  // namespace

void SeenMesh::find(const FractureMesh& mesh, const NearFaces* near, const FrameView& view,
                    const FrameUniforms& frame, const RenderTargets& targets, int shadow_texels,
                    const SeenTriangles::Wanted& wanted) {
    const uint64_t near_version = near != nullptr ? near->version : 0;
    Key key{mesh.version(),  near_version,  frame.view_projection, {},    targets.width, targets.height,
            targets.samples, shadow_texels, view.look.crack_width, wanted};
    std::copy(std::begin(frame.light_matrix), std::end(frame.light_matrix), key.light_matrix);
    if (key == key_) return;
    key_ = key;
    const SampleGrid pictures[] = {gridOf(frame, targets), shadowGrid(frame.light_matrix[0], shadow_texels),
                                   shadowGrid(frame.light_matrix[1], shadow_texels)};
    triangles_.find(mesh, near, pictures, wanted);
    cracks_.find(mesh, view.look.crack_width);
}

}  // namespace demolish::engine
