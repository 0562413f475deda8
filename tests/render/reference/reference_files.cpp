// SPDX-License-Identifier: Apache-2.0
// Blender's axes: what is (x, y, z) with us is (x, -z, y) there.
#include <ImfRgbaFile.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/image/png.h"
#include "engine/render/frame_uniforms.h"
#include "engine/render/mesh_motion.h"
#include "engine/surroundings/surroundings.h"
#include "tests/render/reference/reference_shot.h"

namespace demolish::reference {
namespace {

using engine::FrameView;
using Json = nlohmann::json;

struct Triangle {
    const std::vector<SurfaceVertex>* vertices;
    uint32_t corner[3];
};
struct Piece {
    std::vector<Triangle> outside, inside;
};

glm::vec3 turned(const glm::vec3& v) {
    return {v.x, -v.z, v.y};
}

glm::vec3 rotated(const Float4& q, const glm::vec3& v) {
    const glm::vec3 axis(q.x, q.y, q.z);
    return v + 2.0f * glm::cross(axis, glm::cross(axis, v) + q.w * v);
}

std::map<uint32_t, Piece> piecesOf(const HostFrame& frame) {
    std::map<uint32_t, Piece> pieces;
    const auto add = [&](const std::vector<SurfaceVertex>& vertices, const std::vector<uint32_t>& indices,
                         std::vector<Triangle> Piece::*side) {
        for (size_t i = 0; i + 2 < indices.size(); i += 3) {
            const uint32_t slot = frame.particle_fragment.at(vertices.at(indices[i]).cell);
            (pieces[slot].*side).push_back({&vertices, {indices[i], indices[i + 1], indices[i + 2]}});
        }
    };
    add(frame.exterior_vertices, frame.exterior_indices, &Piece::outside);
    add(frame.interior_vertices, frame.interior_indices, &Piece::inside);
    return pieces;
}

class ObjFile {
  public:
    explicit ObjFile(const std::filesystem::path& file) : out_(file) {}

    void add(uint32_t slot, const Piece& piece, const FragmentTransform& motion) {
        out_ << "o piece_" << slot << '\n';
        write("outside", piece.outside, motion);
        write("inside", piece.inside, motion);
    }
    bool good() { return static_cast<bool>(out_.flush()); }

  private:
    void write(const char* material, const std::vector<Triangle>& triangles,
               const FragmentTransform& motion) {
        if (triangles.empty()) return;
        out_ << "usemtl " << material << "\ns 1\n";
        std::map<uint32_t, size_t> numbers;
        for (const Triangle& triangle : triangles)
            for (const uint32_t corner : triangle.corner)
                if (numbers.emplace(corner, count_ + numbers.size() + 1).second)
                    writeVertex((*triangle.vertices)[corner], motion);
        for (const Triangle& triangle : triangles) {
            out_ << 'f';
            for (const uint32_t corner : triangle.corner)
                out_ << ' ' << numbers.at(corner) << "//" << numbers.at(corner);
            out_ << '\n';
        }
        count_ += numbers.size();
    }
    void writeVertex(const SurfaceVertex& vertex, const FragmentTransform& motion) {
        const float scale = 1 - kShrinkStep * static_cast<float>(motion.shrink);
        const Float3 p = vertex.position, t = motion.translation;
        const glm::vec3 place =
            turned(rotated(motion.rotation, scale * glm::vec3(p.x, p.y, p.z)) + glm::vec3(t.x, t.y, t.z));
        const glm::vec3 normal = turned(rotated(motion.rotation, engine::normalOf(vertex.normal)));
        out_ << "v " << place.x << ' ' << place.y << ' ' << place.z << "\nvn " << normal.x << ' ' << normal.y
             << ' ' << normal.z << '\n';
    }
    std::ofstream out_;
    size_t count_ = 0;
};

Json list(const glm::vec3& v) {
    return {v.x, v.y, v.z};
}
template <size_t kSize>
Json list(const float (&v)[kSize]) {
    return Json(std::vector<float>(v, v + kSize));
}

Json lookOf(const engine::SurfaceLook& look) {
    return {{"outside", list(look.exterior_colour)},
            {"outside_roughness", look.exterior_roughness},
            {"inside", list(look.interior_colour)},
            {"inside_roughness", look.interior_roughness},
            {"refraction_index", look.refraction_index},
            {"absorption", list(look.absorption)},
            {"frost", look.frost}};
}

Json sceneOf(const ReferenceShot& shot) {
    const FrameView& view = shot.view;
    const engine::Lighting& light = view.lighting;
    Json balls = Json::array();
    for (const ParticleInstance& ball : shot.frame.projectiles)
        if (ball.radius > 0)
            balls.push_back({{"at", list(turned({ball.position.x, ball.position.y, ball.position.z}))},
                             {"radius", ball.radius}});
    return {{"width", view.width},
            {"height", view.height},
            {"eye", list(turned(view.camera.eye))},
            {"target", list(turned(view.camera.target))},
            {"field_of_view", view.camera.field_of_view},
            {"sun_direction", list(turned(light.sun_direction))},
            {"sun_colour", list(light.sun_colour)},
            {"sun_tangent", light.sun_tangent},
            {"exposure", light.exposure},
            {"floor", list(light.floor_colour)},
            {"balls", balls},
            {"look", lookOf(view.look)}};
}

void writeSurroundings(const engine::RadiancePicture& picture, const std::filesystem::path& file) {
    std::vector<Imf::Rgba> pixels;
    pixels.reserve(picture.texels.size());
    for (const glm::vec3& texel : picture.texels) pixels.emplace_back(texel.x, texel.y, texel.z);
    Imf::RgbaOutputFile out(file.c_str(), picture.width, picture.height, Imf::WRITE_RGB);
    out.setFrameBuffer(pixels.data(), 1, static_cast<size_t>(picture.width));
    out.writePixels(picture.height);
}

}  // namespace

void writeShot(const ReferenceShot& shot, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    ObjFile obj(folder / "pieces.obj");
    for (const auto& [slot, piece] : piecesOf(shot.frame))
        obj.add(slot, piece, shot.frame.transforms.at(slot));
    std::ofstream scene(folder / "scene.json");
    scene << sceneOf(shot).dump(2) << '\n';
    if (!obj.good() || !scene.flush()) throw std::runtime_error("cannot write into " + folder.string());
    writeSurroundings(engine::surroundingsOf(shot.view.lighting).backdrop, folder / "surroundings.exr");
    engine::writePng(folder / "ours.png", shot.ours);
}

bool hasBlender() {
    return std::system("command -v blender > /dev/null 2>&1") == 0;
}

engine::Image pathTraced(const std::filesystem::path& folder, int samples) {
    const std::string script = std::string(DEMOLISH_SOURCE_DIR) + "/tests/render/reference/cycles.py";
    const std::string command = "blender --background --factory-startup --python-exit-code 1 --python '" +
                                script + "' -- '" + folder.string() + "' " + std::to_string(samples) +
                                " > '" + (folder / "blender.log").string() + "' 2>&1";
    if (std::system(command.c_str()) != 0)
        throw std::runtime_error("Blender made no picture: see " + (folder / "blender.log").string());
    return engine::readPng(folder / "cycles.png");
}

}  // namespace demolish::reference
