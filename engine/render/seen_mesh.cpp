// SPDX-License-Identifier: Apache-2.0
// Three pictures in one go: a corner is fetched and moved once for all of them.
#include "engine/render/seen_mesh.h"

#include <algorithm>
#include <iterator>

#include "engine/passes/shadow_pass.h"
#include "engine/render/shown.h"

namespace demolish::engine {
namespace {

using Targets = std::array<SmallTriangles::Target, SmallTriangles::kPictures>;

/// The region's u and v, 0..1, as shaders/shadow.vert puts them onto its part of the map.
SmallTriangles::Target shadowTarget(const glm::mat4& light_matrix, int texels) {
    glm::mat4 to_clip = light_matrix;
    for (int column = 0; column < 4; ++column) {
        to_clip[column].x = 2 * light_matrix[column].x - light_matrix[column].w;
        to_clip[column].y = 2 * light_matrix[column].y - light_matrix[column].w;
    }
    return {to_clip, texels, texels};
}

Targets targetsOf(const FrameUniforms& frame, const RenderTargets& targets, int shadow_texels) {
    const auto& at = targets.sample_position;
    return {
        SmallTriangles::Target{
            frame.view_projection, targets.width, targets.height, {at.begin(), at.begin() + targets.samples}},
        shadowTarget(frame.light_matrix[0], shadow_texels),
        shadowTarget(frame.light_matrix[1], shadow_texels)};
}

SampleGrid gridOf(const SmallTriangles::Target& target) {
    return {target.to_clip, target.width, target.height, target.samples};
}

float widestCrack(const FrameView& view) {
    float widest = 0;
    for (const SurfaceLook& look : looksOf(view)) widest = std::max(widest, look.crack_width);
    return widest;
}

}  // namespace

void SeenMesh::find(const FractureMesh& mesh, const NearFaces* near, const FrameView& view,
                    const FrameUniforms& frame, const RenderTargets& targets, int shadow_texels,
                    const SeenTriangles::Wanted& wanted) {
    const bool names_small = namesSmall(mesh, view, near);
    const uint64_t near_version = near != nullptr ? near->version : 0;
    Key key{mesh.version(),  near_version,  frame.view_projection, {},     targets.width, targets.height,
            targets.samples, shadow_texels, widestCrack(view),     wanted, names_small};
    std::copy(std::begin(frame.light_matrix), std::end(frame.light_matrix), key.light_matrix);
    if (key == key_) return;
    key_ = key;
    const Targets all = targetsOf(frame, targets, shadow_texels);
    if (names_small) {
        small_.find(mesh, all, frame, kShadowSlopes, kShadowSteps);
    } else {
        const SampleGrid pictures[] = {gridOf(all[0]), gridOf(all[1]), gridOf(all[2])};
        triangles_.find(mesh, near, pictures, wanted);
    }
    cracks_.find(mesh, widestCrack(view), &frame);
}

}  // namespace demolish::engine
