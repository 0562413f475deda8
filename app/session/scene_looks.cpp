// SPDX-License-Identifier: Apache-2.0
// Bodies of one model share its materials and pictures.
#include "app/session/scene_looks.h"

#include <algorithm>
#include <map>

#include "sim_cuda/api/triangle_mesh.h"

namespace demolish {
namespace {

/// Where a model's materials begin.
using MaterialStarts = std::map<const ModelLooks*, uint32_t>;

engine::PictureUse useOf(const ImageUse& use, uint32_t first_picture) {
    if (use.image == kNoImage) return {};
    return {first_picture + use.image, use.channel, static_cast<engine::PictureWrap>(use.wrap_u),
            static_cast<engine::PictureWrap>(use.wrap_v), use.uv_set};
}

engine::LookMaterial materialOf(const LookMaterial& from, uint32_t first_picture) {
    engine::LookMaterial to;
    std::copy(std::begin(from.base_colour), std::end(from.base_colour), to.base_colour);
    std::copy(std::begin(from.emission), std::end(from.emission), to.emission);
    to.metallic = from.metallic;
    to.roughness = from.roughness;
    to.normal_scale = from.normal_scale;
    to.occlusion_strength = from.occlusion_strength;
    to.alpha_cutoff = from.alpha_cutoff;
    to.is_double_sided = from.is_double_sided != 0;
    to.base = useOf(from.base_map, first_picture);
    to.normal = useOf(from.normal_map, first_picture);
    to.roughness_map = useOf(from.roughness_map, first_picture);
    to.metallic_map = useOf(from.metallic_map, first_picture);
    to.occlusion = useOf(from.occlusion_map, first_picture);
    to.emission_map = useOf(from.emission_map, first_picture);
    return to;
}

uint32_t startOf(const ModelLooks* model, MaterialStarts& starts, engine::BodyLooks& looks) {
    if (model == nullptr) return 0;
    const auto [place, is_new] = starts.try_emplace(model, static_cast<uint32_t>(looks.materials.size()));
    if (!is_new) return place->second;
    const auto first_picture = static_cast<uint32_t>(looks.pictures.size());
    for (const LookMaterial& material : model->materials)
        looks.materials.push_back(materialOf(material, first_picture));
    for (const LookImage& image : model->images)
        looks.pictures.push_back({image.width, image.height, image.texels});
    return place->second;
}

engine::LookTriangle triangleOf(const FractureGeometry& geometry, size_t t, const ModelLooks* looks,
                                uint32_t first_material) {
    engine::LookTriangle to{};
    to.material = engine::kNoLook;
    if (geometry.looks.empty()) return to;
    const TriangleLook& from = geometry.looks[t];
    for (size_t k = 0; k < 3; ++k) {
        const Float3& p = geometry.mesh_triangles[t].corner[k];
        to.corner[k][0] = p.x;
        to.corner[k][1] = p.y;
        to.corner[k][2] = p.z;
        to.uv[k][0] = from.uv[k].x;
        to.uv[k][1] = from.uv[k].y;
        to.second_uv[k][0] = from.second_uv[k].x;
        to.second_uv[k][1] = from.second_uv[k].y;
        to.colour[k] = from.colour[k];
    }
    if (from.material != kNoMaterial && looks->materials[from.material].says_nothing == 0)
        to.material = first_material + from.material;
    return to;
}

}  // namespace

std::optional<engine::BodyLooks> sceneLooks(const SceneSetup& setup) {
    const bool any = std::any_of(setup.bodies.begin(), setup.bodies.end(), [](const BodyInstance& body) {
        return body.body->looks != nullptr && !body.body->geometry.looks.empty();
    });
    if (!any) return std::nullopt;
    engine::BodyLooks looks;
    MaterialStarts starts;
    for (const BodyInstance& instance : setup.bodies) {
        const FractureGeometry& geometry = instance.body->geometry;
        const uint32_t first = startOf(instance.body->looks.get(), starts, looks);
        for (size_t t = 0; t < geometry.mesh_triangles.size(); ++t)
            looks.triangles.push_back(triangleOf(geometry, t, instance.body->looks.get(), first));
    }
    return looks;
}

}  // namespace demolish
