// SPDX-License-Identifier: Apache-2.0
// Sizes of looks that follow from the body.
#include "app/session/picture.h"

#include <algorithm>
#include <cmath>

#include "app/session/scene_colliders.h"
#include "app/session/shot_setup.h"

namespace demolish {

engine::FrameView makeFrameView(const Shot& shot, const BreakableBody& body, int width, int height,
                                engine::RenderQuality quality) {
    const SceneBox box = sceneBox(shot, body);
    const double size_y = body.bounds_max.y - body.bounds_min.y;
    const double body_radius = 0.5 * std::hypot(body.bounds_max.x - body.bounds_min.x, size_y,
                                                body.bounds_max.z - body.bounds_min.z);
    const double radius =
        0.5 * std::hypot(box.high.x - box.low.x, box.high.y - box.low.y, box.high.z - box.low.z);
    engine::FrameView view;
    view.camera = shot.camera ? *shot.camera : framedCamera(box);
    view.lighting = litBy(shot.environment, shot.lighting);
    view.look = shot.look;
    if (!traitsOf(shot.method).smooth_cracks) view.look.noise_strength = 0;
    view.look.noise_scale = static_cast<float>(0.2 * body.spacing);
    if (view.look.crack_width <= 0) view.look.crack_width = static_cast<float>(0.003 * size_y);
    view.width = width;
    view.height = height;
    view.quality = quality;
    // Pieces fly: the shadow map covers a body's size more on every side.
    view.scene_radius = static_cast<float>(radius + 2 * body_radius);
    view.scene_centre[0] = static_cast<float>(0.5 * (box.low.x + box.high.x));
    view.scene_centre[1] = static_cast<float>(0.5 * size_y);
    view.scene_centre[2] = static_cast<float>(0.5 * (box.low.z + box.high.z));
    const float(&centre)[3] = view.scene_centre;
    view.colliders = drawnColliders(shot, {{centre[0], centre[1], centre[2]}, view.scene_radius});
    return view;
}

std::string colourNote(const Shot& shot, bool transparent) {
    const engine::Lighting& light = shot.lighting;
    return "linear light with sRGB primaries, surroundings " + environmentName(shot.environment) +
           ", exposure " + plainNumber(light.exposure) + ", white balance " + plainNumber(light.temperature) +
           " K, tone curve " + toneNames()[static_cast<size_t>(light.tone)] + "; encoded as sRGB" +
           (transparent ? ", straight alpha" : "");
}

}  // namespace demolish
