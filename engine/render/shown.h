// SPDX-License-Identifier: Apache-2.0
// What of a mesh a view shows.
#pragma once
#include <algorithm>
#include <vector>

#include "engine/render/fracture_mesh.h"
#include "engine/render/seen_triangles.h"
#include "engine/scene/frame_view.h"

namespace demolish::engine {

inline bool showsEffects(const FractureMesh* mesh, const FrameView& view) {
    return mesh != nullptr && mesh->effectsShown() && view.show_effects && view.mode == ViewMode::kSurface;
}

inline bool showsDust(const FractureMesh* mesh, const FrameView& view) {
    return showsEffects(mesh, view) && mesh->effectsFly();
}

/// All looks of a view, look 0 first.
inline std::vector<SurfaceLook> looksOf(const FrameView& view) {
    std::vector<SurfaceLook> looks{view.look};
    looks.insert(looks.end(), view.more_looks.begin(), view.more_looks.end());
    if (looks.size() > kMostLooks) looks.resize(kMostLooks);
    return looks;
}

/// For kHiddenLooks: none of the looks but those which are transparent, or are not. 0 hides nothing. Of
/// several, cells of looks that are not among them are hidden, too.
inline uint32_t hiddenUnless(bool transparent, const std::vector<SurfaceLook>& looks) {
    uint32_t hidden = looks.size() == 1 || looks.size() == kMostLooks ? 0 : ~0u << looks.size();
    for (size_t k = 0; k < looks.size(); ++k)
        if (looks[k].isTransparent() != transparent) hidden |= 1u << k;
    return hidden;
}
/// All but look k.
inline uint32_t hiddenBut(size_t k, const std::vector<SurfaceLook>& looks) {
    return looks.size() == 1 ? 0 : ~(1u << k);
}

/// Whether some body is transparent, or is not.
inline bool showsAny(bool transparent, const FractureMesh* mesh, const FrameView& view) {
    if (mesh == nullptr || view.mode != ViewMode::kSurface) return false;
    const std::vector<SurfaceLook> looks = looksOf(view);
    return std::any_of(looks.begin(), looks.end(),
                       [&](const SurfaceLook& look) { return look.isTransparent() == transparent; });
}
inline bool showsGlass(const FractureMesh* mesh, const FrameView& view) {
    return showsAny(true, mesh, view);
}
/// A body that is drawn among the opaque things.
inline bool showsSolid(const FractureMesh* mesh, const FrameView& view) {
    return showsAny(false, mesh, view);
}

/// Whether passes compute what others draw. Software renderers compute as slowly as they draw.
inline bool mayCompute(const FrameView& view, bool in_software) {
    const bool chosen =
        view.rasteriser == Rasteriser::kAuto ? !in_software : view.rasteriser == Rasteriser::kCompute;
    return chosen && view.quality == RenderQuality::kFull;
}

/// Of all transparent bodies: the optics of the first transparent look.
inline SurfaceLook glassOf(const FrameView& view) {
    for (const SurfaceLook& look : looksOf(view))
        if (look.isTransparent()) return look;
    return view.look;
}

/// Whose outside looks as its model file says.
inline bool showsModelLooks(const FractureMesh* mesh, const FrameView& view) {
    return showsSolid(mesh, view) && view.model_looks && mesh->looks() != nullptr;
}

/// Of a mesh that is drawn: what one can see through hides nothing.
inline SeenTriangles::Wanted wantedOf(const FractureMesh& mesh, const FrameView& view) {
    const LookBuffers* looks = showsModelLooks(&mesh, view) ? mesh.looks() : nullptr;
    const bool has_holes = looks != nullptr && looks->isMasked();
    return {.both_sides = looks != nullptr && looks->isDoubleSided(),
            .hidden = has_holes || showsGlass(&mesh, view)};
}

/// Whether a software renderer's processor finds small triangles itself: in drafts of bodies that all look
/// the same.
inline bool namesSmall(const FractureMesh& mesh, const FrameView& view, const NearFaces* near) {
    return view.quality == RenderQuality::kDraft && near == nullptr && view.more_looks.empty() &&
           view.look.variation <= 0 && !showsModelLooks(&mesh, view);
}

}  // namespace demolish::engine
