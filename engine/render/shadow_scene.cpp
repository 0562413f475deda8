// SPDX-License-Identifier: Apache-2.0
// Everything that a map would show, by value.
#include "engine/render/shadow_scene.h"

#include <algorithm>
#include <iterator>

#include "engine/render/shown.h"

namespace demolish::engine {

ShadowScene shadowSceneOf(const FractureMesh* mesh, const FrameView& view, const NearFaces* near,
                          std::span<const SphereDraw> spheres, const FrameUniforms& frame) {
    ShadowScene scene;
    scene.mesh_version = mesh != nullptr ? mesh->version() : 0;
    scene.near_version = near != nullptr ? near->version : 0;
    scene.as_particles = view.mode == ViewMode::kParticles;
    scene.with_grit = showsEffects(mesh, view);
    scene.with_body = showsSolid(mesh, view);
    scene.hidden_looks = hiddenUnless(false, looksOf(view));
    scene.with_looks = showsModelLooks(mesh, view);
    for (const SphereDraw& sphere : spheres) {
        scene.spheres.insert(scene.spheres.end(), std::begin(sphere.position), std::end(sphere.position));
        scene.spheres.push_back(sphere.radius);
    }
    scene.colliders = view.colliders;
    std::copy(std::begin(frame.light_matrix), std::end(frame.light_matrix), scene.light_matrix);
    return scene;
}

}  // namespace demolish::engine
