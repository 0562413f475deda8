// SPDX-License-Identifier: Apache-2.0
// Both directions go through the same parts, so that they cannot drift apart.
#include "app/reading/mesh_stream.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace demolish {
namespace {

enum class Kind : uint32_t { kMesh = 1, kRefusal = 2, kSet = 3 };
enum class Looks : uint32_t { kNone, kHere, kKnown };

struct Header {
    std::array<char, 8> magic{'D', 'e', 'm', 'o', 'M', 'e', 's', 'h'};
    uint32_t version = 5;
    Kind kind = Kind::kMesh;
    uint64_t text = 0, positions = 0, triangles = 0;
    uint32_t meshes = 0, materials = 0, textures = 0, is_in_metres = 0;
    Looks looks = Looks::kNone;
    uint32_t has_colours = 0, look_materials = 0, images = 0, notes = 0;
    float coarseness = 0;
};
struct ImageHeader {
    uint32_t width = 0, height = 0;
};
static_assert(sizeof(Header) == 80 && sizeof(Double3) == 24 && sizeof(CornerAttributes) == 36,
              "no bytes between the members that nobody has set");

constexpr uint32_t kMostNotes = 4096;
constexpr uint64_t kPart = 1 << 16;  // elements that are sent, summed and made room for at a time

/// FNV-1a over words of eight bytes; the last word of a part is filled up with zeros.
class Checksum {
  public:
    void add(std::span<const uint8_t> bytes) {
        for (size_t at = 0; at < bytes.size(); at += sizeof(uint64_t)) {
            uint64_t word = 0;
            std::memcpy(&word, bytes.data() + at, std::min(sizeof word, bytes.size() - at));
            sum_ = (sum_ ^ word) * 0x100000001b3ull;
        }
    }
    uint64_t value() const { return sum_; }

  private:
    uint64_t sum_ = 0xcbf29ce484222325ull;
};

template <class Value>
std::span<const uint8_t> bytesOf(const Value* values, size_t count) {
    static_assert(std::is_trivially_copyable_v<Value>);
    return {reinterpret_cast<const uint8_t*>(values), count * sizeof(Value)};
}

class Writer {
  public:
    explicit Writer(const std::function<void(std::span<const uint8_t>)>& write) : write_(write) {}

    template <class Array>
    void add(const Array& array) {
        for (size_t at = 0; at < array.size(); at += kPart)
            part(bytesOf(array.data() + at, std::min<size_t>(kPart, array.size() - at)));
    }
    void part(std::span<const uint8_t> bytes) {
        checksum_.add(bytes);
        write_(bytes);
    }
    void finish() {
        const uint64_t sum = checksum_.value();
        write_(bytesOf(&sum, 1));
    }

  private:
    const std::function<void(std::span<const uint8_t>)>& write_;
    Checksum checksum_;
};

class Reader {
  public:
    explicit Reader(const std::function<void(std::span<uint8_t>)>& fill) : fill_(fill) {}

    template <class Array>
    void take(Array& array, uint64_t count) {
        for (uint64_t at = 0; at < count; at += kPart) {
            const uint64_t some = std::min(kPart, count - at);
            array.resize(at + some);
            part(array.data() + at, some);
        }
    }
    template <class Value>
    void part(Value* values, size_t count) {
        const auto bytes = bytesOf(values, count);
        fill_({reinterpret_cast<uint8_t*>(values), bytes.size()});
        checksum_.add(bytes);
    }
    void finish() {
        uint64_t sum = 0;
        fill_({reinterpret_cast<uint8_t*>(&sum), sizeof sum});
        if (sum != checksum_.value()) throw BrokenStream("the checksum is wrong");
    }

  private:
    const std::function<void(std::span<uint8_t>)>& fill_;
    Checksum checksum_;
};

void requireBounded(const Header& header) {
    const Header known;
    if (header.magic != known.magic) throw BrokenStream("these are other bytes");
    if (header.version != known.version) throw BrokenStream("this is another version");
    const uint64_t most_text = header.kind == Kind::kSet ? kMostSetText : kMostText;
    if (header.text > most_text || header.positions > kMostTriangles || header.triangles > kMostTriangles)
        throw BrokenStream("there is too much of something");
    if (header.look_materials > kMostMaterials || header.images > kMostImages || header.notes > kMostNotes)
        throw BrokenStream("there are too many looks");
}

template <class... Numbers>
bool areFinite(Numbers... numbers) {
    return (std::isfinite(numbers) && ...);
}

void requireSound(const TriangleMesh& mesh, size_t materials) {
    for (const Double3& p : mesh.positions)
        if (!areFinite(p.x, p.y, p.z)) throw BrokenStream("a vertex is not a finite number");
    for (const auto& triangle : mesh.triangles)
        for (const uint32_t vertex : triangle)
            if (vertex >= mesh.positions.size()) throw BrokenStream("a vertex is not there");
    for (const auto& triangle : mesh.corners)
        for (const CornerAttributes& c : triangle)
            if (!areFinite(c.normal.x, c.normal.y, c.normal.z, c.uv.x, c.uv.y, c.second_uv.x, c.second_uv.y))
                throw BrokenStream("a corner is not a finite number");
            else if (c.material != kNoMaterial && c.material >= materials)
                throw BrokenStream("a material is not there");
}

void requireSound(const ModelLooks& looks) {
    for (const LookMaterial& m : looks.materials) {
        for (const float value : {m.base_colour[0], m.base_colour[1], m.base_colour[2], m.base_colour[3],
                                  m.emission[0], m.emission[1], m.emission[2], m.metallic, m.roughness,
                                  m.normal_scale, m.occlusion_strength, m.alpha_cutoff})
            if (!areFinite(value)) throw BrokenStream("a material is not a finite number");
        for (const ImageUse& use :
             {m.base_map, m.normal_map, m.metallic_map, m.roughness_map, m.occlusion_map, m.emission_map})
            if ((use.image != kNoImage && use.image >= looks.images.size()) || use.channel > 3 ||
                use.uv_set > 1 || use.wrap_u > TextureWrap::kMirror || use.wrap_v > TextureWrap::kMirror)
                throw BrokenStream("a picture is not there");
    }
}

void writeLooks(const ModelLooks& looks, Writer& writer) {
    writer.add(looks.materials);
    for (size_t i = 0; i < std::min<size_t>(looks.notes.size(), kMostNotes); ++i) {
        const std::string note = looks.notes[i].substr(0, kMostText);
        const uint64_t length = note.size();
        writer.part(bytesOf(&length, 1));
        writer.add(note);
    }
    for (const LookImage& image : looks.images) {
        const ImageHeader header{image.width, image.height};
        writer.part(bytesOf(&header, 1));
        writer.add(image.texels);
    }
}

std::shared_ptr<const ModelLooks> readLooks(const Header& header, Reader& reader) {
    auto looks = std::make_shared<ModelLooks>();
    looks->has_colours = header.has_colours != 0;
    reader.take(looks->materials, header.look_materials);
    for (uint32_t i = 0; i < header.notes; ++i) {
        uint64_t length = 0;
        reader.part(&length, 1);
        if (length > kMostText) throw BrokenStream("a note is too long");
        reader.take(looks->notes.emplace_back(), length);
    }
    uint64_t bytes = 0;
    for (uint32_t i = 0; i < header.images; ++i) {
        ImageHeader size;
        reader.part(&size, 1);
        if (size.width == 0 || size.height == 0 || size.width > kMostImageEdge ||
            size.height > kMostImageEdge)
            throw BrokenStream("a picture has a wrong size");
        const uint64_t own = uint64_t{4} * size.width * size.height;
        bytes += own;
        if (bytes > kMostImageBytes) throw BrokenStream("there is too much of pictures");
        LookImage& image = looks->images.emplace_back();
        image.width = size.width;
        image.height = size.height;
        reader.take(image.texels, own);
    }
    return looks;
}

void writeText(Kind kind, const std::string& text, Writer& writer) {
    Header header;
    header.kind = kind;
    header.text = text.size();
    writer.part(bytesOf(&header, 1));
    writer.add(text);
    writer.finish();
}

void writeModel(const ImportedModel& model, bool looks_known, Writer& writer) {
    const TriangleMesh& mesh = model.mesh;
    const ModelContents& contents = model.contents;
    const std::string text = mesh.name.substr(0, kMostText);
    Header header;
    header.text = text.size();
    header.positions = mesh.positions.size();
    header.triangles = mesh.triangles.size();
    header.meshes = contents.meshes;
    header.materials = contents.materials;
    header.textures = contents.textures;
    header.is_in_metres = contents.is_in_metres ? 1 : 0;
    header.coarseness = contents.coarseness;
    if (model.looks) header.looks = looks_known ? Looks::kKnown : Looks::kHere;
    if (header.looks == Looks::kHere) {
        header.has_colours = model.looks->has_colours ? 1 : 0;
        header.look_materials = static_cast<uint32_t>(model.looks->materials.size());
        header.images = static_cast<uint32_t>(model.looks->images.size());
        header.notes = static_cast<uint32_t>(std::min<size_t>(model.looks->notes.size(), kMostNotes));
    }
    writer.part(bytesOf(&header, 1));
    writer.add(text);
    writer.add(mesh.positions);
    writer.add(mesh.triangles);
    writer.add(mesh.corners);
    if (header.looks == Looks::kHere) writeLooks(*model.looks, writer);
    writer.finish();
}

}  // namespace

void writeAnswer(const ModelAnswer& answer, const std::function<void(std::span<const uint8_t>)>& write,
                 bool looks_known) {
    Writer writer(write);
    if (const auto* refusal = std::get_if<ModelRefusal>(&answer))
        writeText(Kind::kRefusal, refusal->sentence.substr(0, kMostText), writer);
    else if (const auto* set = std::get_if<ModelSetText>(&answer))
        writeText(Kind::kSet, set->text.substr(0, kMostSetText), writer);
    else
        writeModel(std::get<ImportedModel>(answer), looks_known, writer);
}

ModelAnswer readAnswer(const std::function<void(std::span<uint8_t>)>& fill,
                       const std::shared_ptr<const ModelLooks>& known) {
    Reader reader(fill);
    Header header;
    reader.part(&header, 1);
    requireBounded(header);
    std::string text;
    TriangleMesh mesh;
    reader.take(text, header.text);
    reader.take(mesh.positions, header.positions);
    reader.take(mesh.triangles, header.triangles);
    reader.take(mesh.corners, header.triangles);
    std::shared_ptr<const ModelLooks> looks;
    if (header.looks == Looks::kKnown) looks = known;
    if (header.looks == Looks::kHere) looks = readLooks(header, reader);
    reader.finish();
    if (header.kind == Kind::kRefusal) return ModelRefusal{text};
    if (header.kind == Kind::kSet) return ModelSetText{text};
    if (header.kind != Kind::kMesh) throw BrokenStream("this is neither a mesh nor a refusal");
    if (looks) requireSound(*looks);
    requireSound(mesh, looks ? looks->materials.size() : 0);
    mesh.name = std::move(text);
    return ImportedModel{
        std::move(mesh),
        {header.meshes, header.materials, header.textures, header.is_in_metres != 0, header.coarseness},
        std::move(looks)};
}

}  // namespace demolish
