// SPDX-License-Identifier: Apache-2.0
// Formats that know metal and roughness say so; of the others the shininess becomes a roughness.
#include "sim_cuda/authoring/looks/material_import.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <map>
#include <optional>
#include <utility>

#include "sim_cuda/authoring/looks/gltf_left_out.h"
#include "sim_cuda/authoring/looks/image_import.h"
#include "sim_cuda/authoring/looks/mtl_options.h"

namespace demolish {
namespace {

constexpr float kAssimpsGrey = 0.6f;  // of files that name no colour
constexpr float kLeastRoughness = 0.08f;
constexpr float kUsualCutoff = 0.5f;

struct TextureSlot {
    aiTextureType type;
    uint8_t channel = 0;
};

/// By what it tells of how pictures are laid.
enum class Format {
    kGltf,
    kWithRepeats,  ///< DAE, FBX
    kOther
};

Format formatOf(const std::filesystem::path& model) {
    std::string ending = model.extension().string();
    for (char& c : ending) c = char(std::tolower(static_cast<unsigned char>(c)));
    return ending == ".gltf" || ending == ".glb"  ? Format::kGltf
           : ending == ".dae" || ending == ".fbx" ? Format::kWithRepeats
                                                  : Format::kOther;
}

/// What the meshes of a material have.
struct UseOfMaterial {
    int uv_sets = 0;
    bool is_faint = false;     ///< opacities below 1 at the vertices
    bool has_colours = false;  ///< at the vertices
};

class MaterialReader {
  public:
    MaterialReader(const aiMaterial& material, Format format, const UseOfMaterial& use,
                   const MtlOptions& options, ImageImport& images)
        : material_(material),
          name_(material.GetName().C_Str()),
          format_(format),
          is_gltf_(format == Format::kGltf),
          use_(use),
          options_(options),
          images_(images) {}

    LookMaterial read() {
        readMaps();
        readColours();
        readSurface();
        readAlpha();
        int two_sided = 0;
        material_.Get(AI_MATKEY_TWOSIDED, two_sided);
        look_.is_double_sided = two_sided != 0 ? 1 : 0;
        return look_;
    }
    /// After read().
    std::array<UvTransform, 2> uvTransforms() const {
        return {laid_[0].value_or(UvTransform{}), laid_[1].value_or(UvTransform{})};
    }

  private:
    void readMaps() {
        look_.base_map = use({{aiTextureType_BASE_COLOR}, {aiTextureType_DIFFUSE}});
        look_.normal_map = use({{aiTextureType_NORMALS}, {aiTextureType_NORMAL_CAMERA}});
        if (look_.normal_map.image == kNoImage) look_.normal_map = bumpThatBends();
        look_.emission_map = use({{aiTextureType_EMISSION_COLOR}, {aiTextureType_EMISSIVE}});
        // glTF packs roughness into green and metal into blue; occlusion is red.
        const uint8_t rough = is_gltf_ ? 1 : 0, metal = is_gltf_ ? 2 : 0;
        look_.roughness_map = use({{aiTextureType_DIFFUSE_ROUGHNESS, rough}});
        look_.metallic_map = use({{aiTextureType_METALNESS, metal}});
        if (is_gltf_ && look_.metallic_map.image == kNoImage) {
            look_.roughness_map = use({{aiTextureType_UNKNOWN, rough}});
            look_.metallic_map = use({{aiTextureType_UNKNOWN, metal}});
        }
        look_.occlusion_map = is_gltf_ ? use({{aiTextureType_LIGHTMAP}, {aiTextureType_AMBIENT_OCCLUSION}})
                                       : use({{aiTextureType_AMBIENT_OCCLUSION}});
    }

    /// The first of these that the material has.
    ImageUse use(std::initializer_list<TextureSlot> slots) {
        for (const TextureSlot& slot : slots) {
            aiString path;
            material_.GetTexture(slot.type, 0, &path);
            const MtlPicture* with_options = options_.find(name_, slot.type);
            const std::string name = with_options != nullptr ? with_options->name : path.C_Str();
            if (name.empty()) continue;
            int uv_set = 0, wrap_u = aiTextureMapMode_Wrap, wrap_v = aiTextureMapMode_Wrap;
            material_.Get(AI_MATKEY_UVWSRC(slot.type, 0), uv_set);
            // Of a file whose only set is its number 1, assimp keeps the number and moves the set to 0.
            if (use_.uv_sets < 2) uv_set = 0;
            if (uv_set < 0 || uv_set > 1) {
                images_.note("the texture '" + name + "' lies on a third set of UVs and is left out");
                return {};
            }
            noteHowLaid(slot.type, name, with_options, laid_[size_t(uv_set)]);
            material_.Get(AI_MATKEY_MAPPINGMODE_U(slot.type, 0), wrap_u);
            material_.Get(AI_MATKEY_MAPPINGMODE_V(slot.type, 0), wrap_v);
            return {images_.imageOf(name), slot.channel, wrapOf(wrap_u), wrapOf(wrap_v),
                    static_cast<uint8_t>(uv_set)};
        }
        return {};
    }
    /// The first picture of a set says how all of them are laid over it: the colours, where there are any.
    void noteHowLaid(aiTextureType type, const std::string& name, const MtlPicture* with_options,
                     std::optional<UvTransform>& laid) {
        const UvTransform own = with_options != nullptr ? with_options->laid : laidAs(type, name);
        if (with_options != nullptr)
            for (const std::string& option : with_options->unfollowed)
                images_.note("the option " + option + " of the texture '" + name + "' is not followed");
        if (!laid) laid = own;
        if (*laid != own)
            images_.note("the texture '" + name +
                         "' is laid otherwise than the others of its material, and "
                         "follows them");
    }
    UvTransform laidAs(aiTextureType type, const std::string& name) {
        aiUVTransform transform;
        if (format_ == Format::kOther ||
            material_.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) != aiReturn_SUCCESS)
            return {};
        if (is_gltf_) return uvTransformOfGltf(transform);
        if (transform.mRotation != 0) images_.note("the turn of the texture '" + name + "' is not followed");
        return uvTransformOfRepeats(transform);
    }
    static TextureWrap wrapOf(int mode) {
        return mode == aiTextureMapMode_Mirror                                    ? TextureWrap::kMirror
               : mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? TextureWrap::kClamp
                                                                                  : TextureWrap::kRepeat;
    }

    /// Normal maps are often named where heights belong: they are blue.
    ImageUse bumpThatBends() {
        const ImageUse bump = use({{aiTextureType_HEIGHT}});
        if (bump.image == kNoImage) return bump;
        const std::vector<uint8_t>& texels = images_.at(bump.image).texels;
        uint64_t red = 0, blue = 0;
        for (size_t i = 0; i < texels.size(); i += 4) {
            red += texels[i];
            blue += texels[i + 2];
        }
        return blue > red + red / 4 ? bump : ImageUse{};
    }

    void readColours() {
        aiColor4D colour(1, 1, 1, 1);
        // Of a glTF that tells specular and glossiness, the base colour is not meant.
        if (isGlossy() || material_.Get(AI_MATKEY_BASE_COLOR, colour) != aiReturn_SUCCESS)
            material_.Get(AI_MATKEY_COLOR_DIFFUSE, colour);
        const bool has_map = look_.base_map.image != kNoImage;
        // Exporters write black or assimp's grey beside a picture and do not mean it.
        const float lightest = std::max({colour.r, colour.g, colour.b});
        const bool unmeant = has_map && !is_gltf_ && (lightest == 0 || isAssimpsGrey(colour));
        if (unmeant) colour = aiColor4D(1, 1, 1, colour.a);
        setNumbers(look_.base_colour, {colour.r, colour.g, colour.b, colour.a}, 1);
        aiColor4D glow(0, 0, 0, 1);
        float intensity = 1;
        material_.Get(AI_MATKEY_COLOR_EMISSIVE, glow);
        material_.Get(AI_MATKEY_EMISSIVE_INTENSITY, intensity);
        const bool black = glow.r == 0 && glow.g == 0 && glow.b == 0;
        if (!is_gltf_ && black && look_.emission_map.image != kNoImage) glow = aiColor4D(1, 1, 1, 1);
        setNumbers(look_.emission, {glow.r * intensity, glow.g * intensity, glow.b * intensity}, 100);
    }

    bool isGlossy() const {
        float glossiness = 0;
        return is_gltf_ && material_.Get(AI_MATKEY_GLOSSINESS_FACTOR, glossiness) == aiReturn_SUCCESS;
    }

    static bool isAssimpsGrey(const aiColor4D& colour) {
        return colour.r == kAssimpsGrey && colour.g == kAssimpsGrey && colour.b == kAssimpsGrey;
    }

    void readSurface() {
        float shininess = 0, metallic = 0, roughness = 1;
        material_.Get(AI_MATKEY_SHININESS, shininess);
        const bool knows_metal = material_.Get(AI_MATKEY_METALLIC_FACTOR, metallic) == aiReturn_SUCCESS;
        const bool knows_roughness = material_.Get(AI_MATKEY_ROUGHNESS_FACTOR, roughness) == aiReturn_SUCCESS;
        if (!knows_metal) metallic = look_.metallic_map.image != kNoImage ? 1.0f : 0.0f;
        if (!knows_roughness)
            roughness = look_.roughness_map.image != kNoImage ? 1.0f
                        : shininess > 0                       ? std::sqrt(2 / (shininess + 2))
                                                              : 0.6f;
        setNumbers(&look_.metallic, {metallic}, 1);
        setNumbers(&look_.roughness, {roughness}, 1);
        look_.roughness = std::max(look_.roughness, kLeastRoughness);
        if (isGlossy()) {
            float glossiness = 0;
            material_.Get(AI_MATKEY_GLOSSINESS_FACTOR, glossiness);
            setNumbers(&look_.metallic, {0}, 1);
            setNumbers(&look_.roughness, {1 - glossiness}, 1);
            look_.roughness = std::max(look_.roughness, kLeastRoughness);
        }
        float scale = 1, strength = 1;
        material_.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), scale);
        material_.Get(AI_MATKEY_GLTF_TEXTURE_STRENGTH(aiTextureType_LIGHTMAP, 0), strength);
        for (const aiTextureType type : {aiTextureType_NORMALS, aiTextureType_HEIGHT})
            if (const MtlPicture* picture = options_.find(name_, type)) scale = picture->bump;
        setNumbers(&look_.normal_scale, {scale}, 10);
        setNumbers(&look_.occlusion_strength, {strength}, 1);
    }

    /// glTF says what is blended; elsewhere a picture with holes is cut out.
    void readAlpha() {
        aiString mode;
        float cutoff = kUsualCutoff;
        material_.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
        material_.Get(AI_MATKEY_GLTF_ALPHAMODE, mode);
        const std::string said = mode.C_Str();
        aiString opacity, base;
        const bool by_map = material_.GetTexture(aiTextureType_OPACITY, 0, &opacity) == aiReturn_SUCCESS &&
                            material_.GetTexture(aiTextureType_DIFFUSE, 0, &base) == aiReturn_SUCCESS &&
                            opacity == base;
        if (said == "BLEND" && (look_.base_colour[3] < 1 || hasHoles())) look_.alpha_cutoff = kBlends;
        const bool cut = said == "MASK" || (by_map && look_.base_colour[3] > kUsualCutoff);
        if (cut && hasHoles()) setNumbers(&look_.alpha_cutoff, {cutoff}, 1);
    }
    bool hasHoles() const {
        if (is_gltf_ && use_.is_faint) return true;
        if (look_.base_map.image == kNoImage) return false;
        const std::vector<uint8_t>& texels = images_.at(look_.base_map.image).texels;
        for (size_t i = 3; i < texels.size(); i += 4)
            if (texels[i] < 255) return true;
        return false;
    }

    /// Files may hold anything.
    static void setNumbers(float* to, std::initializer_list<float> values, float most) {
        for (const float value : values) *to++ = std::isfinite(value) ? std::clamp(value, 0.0f, most) : 0.0f;
    }

    const aiMaterial& material_;
    const std::string name_;
    Format format_;
    bool is_gltf_;
    UseOfMaterial use_;
    const MtlOptions& options_;
    ImageImport& images_;
    LookMaterial look_;
    std::array<std::optional<UvTransform>, 2> laid_;
};

/// Of colours without opacity assimp leaves it at 0.
bool isFaint(const aiMesh& mesh) {
    if (!mesh.HasVertexColors(0)) return false;
    const aiColor4D *begin = mesh.mColors[0], *end = begin + mesh.mNumVertices;
    return std::any_of(begin, end, [](const aiColor4D& c) { return c.a != 0; }) &&
           std::any_of(begin, end, [](const aiColor4D& c) { return c.a < 1; });
}

bool isGrey(const LookMaterial& look, float grey) {
    return std::all_of(look.base_colour, look.base_colour + 3, [grey](float c) { return c == grey; });
}

bool glows(const LookMaterial& look) {
    return std::any_of(std::begin(look.emission), std::end(look.emission), [](float e) { return e > 0; });
}

bool saysColour(const LookMaterial& look) {
    return glows(look) || (!isGrey(look, 1) && !isGrey(look, kAssimpsGrey));
}

/// Of an OBJ's usemtl that no MTL describes, or of faces without any.
bool isAsAssimpMakesIt(const LookMaterial& look) {
    return isGrey(look, kAssimpsGrey) && !glows(look);
}

bool namesTexture(const aiMaterial& material) {
    for (int type = aiTextureType_NONE + 1; type <= AI_TEXTURE_TYPE_MAX; ++type)
        if (material.GetTextureCount(aiTextureType(type)) > 0) return true;
    return false;
}

}  // namespace

ImportedLooks importLooks(const std::filesystem::path& model, const aiScene& scene) {
    auto looks = std::make_shared<ModelLooks>();
    std::map<unsigned, UseOfMaterial> uses;  // of the materials that are used
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[i];
        UseOfMaterial& use = uses[mesh.mMaterialIndex];
        use.uv_sets = std::max(use.uv_sets, static_cast<int>(mesh.GetNumUVChannels()));
        use.is_faint = use.is_faint || isFaint(mesh);
        use.has_colours = use.has_colours || mesh.HasVertexColors(0);
        looks->has_colours = looks->has_colours || mesh.HasVertexColors(0);
    }
    ImageImport images(model, scene);
    const MtlOptions options(model);
    std::vector<std::array<UvTransform, 2>> uv_transforms;
    bool any = looks->has_colours;
    const unsigned count = std::min<unsigned>(scene.mNumMaterials, kMostMaterials);
    for (unsigned m = 0; m < count; ++m) {
        looks->materials.emplace_back();
        uv_transforms.emplace_back();
        const auto used = uses.find(m);
        if (used == uses.end()) continue;
        MaterialReader reader(*scene.mMaterials[m], formatOf(model), used->second, options, images);
        looks->materials[m] = reader.read();
        uv_transforms[m] = reader.uvTransforms();
        LookMaterial& look = looks->materials[m];
        const bool has_picture =
            namesTexture(*scene.mMaterials[m]) || options.names(scene.mMaterials[m]->GetName().C_Str());
        look.says_nothing = !has_picture && !used->second.has_colours && isAsAssimpMakesIt(look) ? 1 : 0;
        any = any || saysColour(look) || has_picture;
    }
    const GltfLeftOut left = gltfLeftOut(model);
    for (const std::string& note : left.pictures) images.note(note);
    any = any || !left.pictures.empty();
    looks->images = images.takeImages();
    looks->notes = images.takeNotes();
    looks->notes.insert(looks->notes.end(), left.nodes.begin(), left.nodes.end());
    if (!any) {
        looks->materials.clear();
        uv_transforms.clear();
        if (looks->notes.empty()) looks = nullptr;
    }
    return {std::move(looks), std::move(uv_transforms)};
}

}  // namespace demolish
