// SPDX-License-Identifier: Apache-2.0
// What of a mesh a view shows.
#pragma once
#include "engine/render/fracture_mesh.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

inline bool showsEffects(const FractureMesh* mesh, const FrameView& view) {
    return mesh != nullptr && mesh->effectsShown() && view.show_effects && view.mode == ViewMode::kSurface;
}

inline bool showsDust(const FractureMesh* mesh, const FrameView& view) {
    return showsEffects(mesh, view) && mesh->effectsFly();
}

/// A transparent body.
inline bool showsGlass(const FractureMesh* mesh, const FrameView& view) {
    return mesh != nullptr && view.mode == ViewMode::kSurface && view.look.isTransparent();
}

/// A body that is drawn among the opaque things.
inline bool showsSolid(const FractureMesh* mesh, const FrameView& view) {
    return mesh != nullptr && view.mode == ViewMode::kSurface && !view.look.isTransparent();
}

}  // namespace demolish::engine
