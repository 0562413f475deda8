// SPDX-License-Identifier: Apache-2.0
// Sizes of looks that follow from the body.
#include "app/session/picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/session/cables.h"
#include "app/session/scene_colliders.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_setup.h"

namespace demolish {
namespace {

/// Looks of the bodies, with what follows from the size of a body and its cells.
std::vector<engine::SurfaceLook> sizedLooks(const Shot& shot, const BodyList& bodies) {
    ShotLooks list = looksOf(shot);
    for (size_t k = 0; k < list.looks.size(); ++k) {
        engine::SurfaceLook& look = list.looks[k];
        const BreakableBody& body = *bodies.at(list.example[k]);
        if (!traitsOf(shot.method).smooth_cracks) look.noise_strength = look.relief_height = 0;
        look.relief_height *= static_cast<float>(body.spacing);
        look.relief_size *= static_cast<float>(body.spacing);
        look.noise_scale = static_cast<float>(0.2 * body.spacing);
        if (list.of_body.size() == 1) look.variation = 0;  // there is nothing that it could differ from
        if (look.crack_width <= 0)
            look.crack_width = static_cast<float>(0.003 * (body.bounds_max.y - body.bounds_min.y));
    }
    return std::move(list.looks);
}

}  // namespace

engine::Camera shotCamera(const Shot& shot, const BodyList& bodies, double time) {
    if (!shot.camera) return framedCamera(sceneBox(shot, bodies));
    return cameraAt(*shot.camera, shot.camera_path, time);
}

engine::FrameView makeFrameView(const Shot& shot, const BodyList& bodies, int width, int height,
                                engine::RenderQuality quality) {
    const SceneBox box = sceneBox(shot, bodies);
    const BreakableBody& body = *bodies.at(subjectOf(shot));
    const double body_radius =
        0.5 * std::hypot(body.bounds_max.x - body.bounds_min.x, body.bounds_max.y - body.bounds_min.y,
                         body.bounds_max.z - body.bounds_min.z);
    const double radius =
        0.5 * std::hypot(box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z);
    engine::FrameView view;
    view.camera = shotCamera(shot, bodies, 0);
    view.lighting = litBy(shot.environment, shot.lighting);
    const std::vector<engine::SurfaceLook> looks = sizedLooks(shot, bodies);
    view.look = looks[0];
    view.more_looks.assign(looks.begin() + 1, looks.end());
    view.model_looks = shot.looks == LooksOf::kFile;
    view.width = width;
    view.height = height;
    view.quality = quality;
    // Pieces fly: the shadow map covers a body's size more on every side.
    view.scene_radius = static_cast<float>(radius + 2 * body_radius);
    view.scene_centre[0] = static_cast<float>(0.5 * (box.low.x + box.high.x));
    view.scene_centre[1] = static_cast<float>(0.5 * (body.bounds_max.y - body.bounds_min.y));
    view.scene_centre[2] = static_cast<float>(0.5 * (box.low.z + box.high.z));
    const float(&centre)[3] = view.scene_centre;
    view.colliders = drawnColliders(shot, {{centre[0], centre[1], centre[2]}, view.scene_radius});
    hangCables(shot, 0, view);
    return view;
}

void hangCables(const Shot& shot, double time, engine::FrameView& view) {
    std::erase_if(view.colliders, [](const engine::ColliderDraw& draw) { return draw.is_steel; });
    for (engine::ColliderDraw& cable : drawnCables(shot, time)) view.colliders.push_back(std::move(cable));
}

std::string colourNote(const Shot& shot, bool transparent) {
    const engine::Lighting& light = shot.lighting;
    return "linear light with sRGB primaries, surroundings " + environmentName(shot.environment) +
           ", exposure " + plainNumber(light.exposure) + ", white balance " + plainNumber(light.temperature) +
           " K, tone curve " + toneNames()[static_cast<size_t>(light.tone)] + "; encoded as sRGB" +
           (transparent ? ", straight alpha" : "");
}

}  // namespace demolish
