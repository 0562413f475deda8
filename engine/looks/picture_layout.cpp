// SPDX-License-Identifier: Apache-2.0
// Two sizes, so that swatches do not grow to the size of scans.
#include "engine/looks/picture_layout.h"

#include <algorithm>

namespace demolish::engine {
namespace {

void add(const PictureUse& use, uint32_t small_array, const BodyLooks& looks, PictureArrays& arrays) {
    if (use.picture == kNoPicture) return;
    const LookPicture& picture = looks.pictures[use.picture];
    const bool is_large = std::max(picture.width, picture.height) > kSmallPicture;
    PictureArray& array = arrays[small_array + (is_large ? 1 : 0)];
    if (std::find(array.pictures.begin(), array.pictures.end(), use.picture) != array.pictures.end()) return;
    array.pictures.push_back(use.picture);
    array.width = std::max(array.width, picture.width);
    array.height = std::max(array.height, picture.height);
}

void halve(PictureArray& array) {
    array.width = std::max(1u, array.width / 2);
    array.height = std::max(1u, array.height / 2);
}

}  // namespace

uint64_t bytesOf(const PictureArrays& arrays) {
    uint64_t bytes = 0;
    for (const PictureArray& array : arrays)
        bytes += uint64_t{4} * array.width * array.height * array.pictures.size() * 4 / 3;
    return bytes;
}

PictureArrays layOut(const BodyLooks& looks, uint32_t largest, uint64_t most_bytes) {
    PictureArrays arrays;
    for (const LookMaterial& material : looks.materials) {
        add(material.base, 0, looks, arrays);
        add(material.emission_map, 0, looks, arrays);
        for (const PictureUse& use :
             {material.normal, material.roughness_map, material.metallic_map, material.occlusion})
            add(use, kFirstNumbers, looks, arrays);
    }
    for (PictureArray& array : arrays)
        while (std::max(array.width, array.height) > largest) halve(array);
    while (bytesOf(arrays) > most_bytes) {
        const auto largest_array =
            std::max_element(arrays.begin(), arrays.end(), [](const PictureArray& a, const PictureArray& b) {
                return uint64_t{a.width} * a.height * a.pictures.size() <
                       uint64_t{b.width} * b.height * b.pictures.size();
            });
        if (largest_array->width == 1 && largest_array->height == 1) break;
        halve(*largest_array);
    }
    return arrays;
}

}  // namespace demolish::engine
