// SPDX-License-Identifier: Apache-2.0
// Packs as the shader unpacks; pictures of other sizes than their array's are resized by the system's stb.
#include "engine/looks/look_buffers.h"

#include <stb/stb_image_resize.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace demolish::engine {
namespace {

constexpr GLuint kBinding = 15, kFirstUnit = 16;
constexpr float kAnisotropy = 8;
// As shaders/common/model_looks.glsl.
constexpr uint32_t kHeaderWords = 4, kMaterialWords = 18, kTriangleWords = 25, kSetsFrom = 26,
                   kPictureBit = 0x80000000u;

class Words {
  public:
    void add(uint32_t word) { words_.push_back(word); }
    void add(float value) { add(std::bit_cast<uint32_t>(value)); }
    size_t size() const { return words_.size(); }
    uint32_t& operator[](size_t at) { return words_[at]; }
    std::span<const std::byte> bytes() const { return std::as_bytes(std::span(words_)); }
    void reserve(size_t count) { words_.reserve(count); }

  private:
    std::vector<uint32_t> words_;
};

uint32_t packed(const PictureUse& use, uint32_t small_array, const PictureArrays& arrays) {
    if (use.picture == kNoPicture) return 0;
    for (uint32_t a = small_array; a < small_array + 2; ++a) {
        const auto& pictures = arrays[a].pictures;
        const auto place = std::find(pictures.begin(), pictures.end(), use.picture);
        if (place == pictures.end()) continue;
        return kPictureBit | static_cast<uint32_t>(place - pictures.begin()) | (a & 1u) << 12 |
               uint32_t{use.channel} << 13 | static_cast<uint32_t>(use.wrap_u) << 15 |
               static_cast<uint32_t>(use.wrap_v) << 17;
    }
    return 0;
}

void addMaterial(const LookMaterial& m, const PictureArrays& arrays, Words& words) {
    for (const float value : m.base_colour) words.add(value);
    for (const float value : m.emission) words.add(value);
    for (const float value : {m.metallic, m.roughness, m.normal_scale, m.occlusion_strength, m.alpha_cutoff})
        words.add(value);
    words.add(packed(m.base, 0, arrays));
    words.add(packed(m.emission_map, 0, arrays));
    for (const PictureUse& use : {m.normal, m.roughness_map, m.metallic_map, m.occlusion})
        words.add(packed(use, kFirstNumbers, arrays));
}

/// The material's number, and above it the set of UVs of each of its maps.
uint32_t materialWord(uint32_t number, const std::vector<LookMaterial>& materials) {
    if (number == kNoLook) return kNoLook;
    const LookMaterial& m = materials.at(number);
    uint32_t word = number, bit = kSetsFrom;
    for (const PictureUse* use :
         {&m.base, &m.emission_map, &m.normal, &m.roughness_map, &m.metallic_map, &m.occlusion})
        word |= uint32_t{use->uv_set} << bit++;
    return word;
}

void addTriangle(const LookTriangle& t, const std::vector<LookMaterial>& materials, Words& words) {
    for (const auto& corner : t.corner)
        for (const float value : corner) words.add(value);
    for (size_t k = 0; k < 3; ++k)
        for (const float value : {t.uv[k][0], t.uv[k][1], t.second_uv[k][0], t.second_uv[k][1]})
            words.add(value);
    for (const uint32_t colour : t.colour) words.add(colour);
    words.add(materialWord(t.material, materials));
}

std::vector<uint8_t> resized(const LookPicture& picture, const PictureArray& array, bool is_colour) {
    std::vector<uint8_t> texels(size_t{4} * array.width * array.height);
    const auto of = [](uint32_t size) { return static_cast<int>(size); };
    if (is_colour)
        stbir_resize_uint8_srgb_edgemode(picture.texels.data(), of(picture.width), of(picture.height), 0,
                                         texels.data(), of(array.width), of(array.height), 0, 4, 3,
                                         STBIR_FLAG_ALPHA_PREMULTIPLIED, STBIR_EDGE_WRAP);
    else
        stbir_resize_uint8_generic(picture.texels.data(), of(picture.width), of(picture.height), 0,
                                   texels.data(), of(array.width), of(array.height), 0, 4,
                                   STBIR_ALPHA_CHANNEL_NONE, 0, STBIR_EDGE_WRAP, STBIR_FILTER_DEFAULT,
                                   STBIR_COLORSPACE_LINEAR, nullptr);
    return texels;
}

gl::Texture textureOf(const PictureArray& array, bool are_colours, const BodyLooks& looks) {
    const auto layers = static_cast<int>(array.pictures.size());
    const int levels = static_cast<int>(std::bit_width(std::max(array.width, array.height)));
    gl::Texture texture =
        gl::Texture::makeArray(are_colours ? GL_SRGB8_ALPHA8 : GL_RGBA8, static_cast<int>(array.width),
                               static_cast<int>(array.height), layers, levels);
    for (int layer = 0; layer < layers; ++layer) {
        const LookPicture& picture = looks.pictures[array.pictures[static_cast<size_t>(layer)]];
        const bool fits = picture.width == array.width && picture.height == array.height;
        const std::vector<uint8_t> other =
            fits ? std::vector<uint8_t>{} : resized(picture, array, are_colours);
        texture.uploadLayer(layer, fits ? picture.texels.data() : other.data());
    }
    texture.makeMipMaps(kAnisotropy);
    return texture;
}

bool showsGlow(const LookMaterial& m) {
    return m.emission[0] > 0 || m.emission[1] > 0 || m.emission[2] > 0 || m.occlusion.picture != kNoPicture;
}

}  // namespace

LookBuffers::LookBuffers(const BodyLooks& looks) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    const PictureArrays arrays = layOut(looks, static_cast<uint32_t>(largest));
    for (uint32_t a = 0; a < kPictureArrays; ++a)
        if (!arrays[a].pictures.empty()) arrays_[a] = textureOf(arrays[a], a < kFirstNumbers, looks);
    Words words;
    words.reserve(kHeaderWords + kMaterialWords * looks.materials.size() +
                  kTriangleWords * looks.triangles.size());
    for (uint32_t k = 0; k < kHeaderWords; ++k) words.add(0u);
    for (const LookMaterial& material : looks.materials) {
        addMaterial(material, arrays, words);
        is_masked_ = is_masked_ || material.alpha_cutoff != 0;
        is_double_sided_ = is_double_sided_ || (material.alpha_cutoff != 0 && material.is_double_sided);
        glows_ = glows_ || showsGlow(material);
    }
    words[0] = static_cast<uint32_t>(words.size());
    for (const LookTriangle& triangle : looks.triangles) addTriangle(triangle, looks.materials, words);
    words_ = gl::Buffer::immutable(words.bytes().size(), words.bytes().data());
}

void LookBuffers::bind() const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, kBinding, words_.id());
    for (uint32_t a = 0; a < kPictureArrays; ++a) arrays_[a].bind(kFirstUnit + a);
}

}  // namespace demolish::engine
