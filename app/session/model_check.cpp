// SPDX-License-Identifier: Apache-2.0
// The way of a shot up to its cells, looked at.
#include "app/session/model_check.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/reading/model_reader.h"
#include "app/session/built_shot.h"
#include "app/session/model_shot.h"
#include "app/session/shot_bodies.h"
#include "app/session/shot_setup.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kThinShare = 0.02;  // of the surface

template <class... Values>
std::string printed(const char* format, Values... values) {
    char text[256];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

std::string counted(size_t count, const char* what) {
    return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

void lookAtMesh(const Shot& shot, const SolidMesh& mesh, Advised advised, ModelCheck& check) {
    check.unit = shot.part.unit;
    check.repair = repairReport(mesh);
    check.solid = meshInfo(mesh);
    check.size_remark = sizeRemark(shot, check.solid.bounds_min, check.solid.bounds_max, advised);
    check.thin_wall = thinWall(mesh, kThinShare);
}

void lookAtBody(const Shot& shot, const BreakableBody& body, ModelCheck& check) {
    check.particles = static_cast<uint32_t>(body.particles.size());
    if (body.remeshed) check.repair.remeshed = RemeshCause::kCells;
    if (body.remeshed) check.repair.untouched = false;
    check.spacing = body.spacing;
    check.open_cells = body.open_cells;
    Shot fired = shot;
    chooseVelocity(fired, body);
    check.velocity = fired.impact.velocity;
}

/// Of a model so far from its origin that it comes out stepped; else empty.
std::string coarseRemark(const ModelCheck& check) {
    constexpr double kFine = 1e-4;  // of the longest side
    const double longest = std::max({check.size_in_file.x, check.size_in_file.y, check.size_in_file.z});
    if (!(double(check.contents.coarseness) > kFine * longest)) return "";
    return printed(
        "; so far from its origin lie its points that they are told to %.2g only, and it comes out stepped: "
        "move it to the origin before its export",
        double(check.contents.coarseness));
}

std::string sizeLine(const ModelCheck& check) {
    const Double3& s = check.size_in_file;
    std::string line = printed("%.4g x %.4g x %.4g", s.x, s.y, s.z);
    if (check.contents.is_in_metres)
        line += " m";
    else if (check.unit > 0)
        line += printed(", in units of %g m", check.unit);
    else if (check.size_remark.empty())
        line += " in a unit that the format does not say";
    if (!check.size_remark.empty()) line += "; " + check.size_remark;
    return line + coarseRemark(check);
}

std::string looksLine(const ModelCheck& check) {
    std::string line =
        counted(check.contents.materials, "material") + ", " + counted(check.contents.textures, "texture");
    if (!check.looks || check.looks->materials.empty())
        return line + "; the file says no colours, so the outside is the material's";
    uint32_t width = 0, height = 0;
    size_t bytes = 0;
    for (const LookImage& image : check.looks->images) {
        width = std::max(width, image.width);
        height = std::max(height, image.height);
        bytes += image.texels.size();
    }
    if (bytes > 0)
        line += printed(" (%.3g MB decoded, at most %u x %u px)", 1e-6 * double(bytes), width, height);
    return check.looks->has_colours ? line + ", colours at the vertices" : line;
}

std::string wallLine(const ModelCheck& check) {
    return printed("2 %% of the surface lies over walls thinner than %.3g m, %.2g particles of %.3g m",
                   check.thin_wall, check.thin_wall / check.spacing, check.spacing);
}

std::string breaksLine(const ModelCheck& check) {
    if (!check.refusal.empty()) return "no: " + check.refusal;
    std::string line = "yes: " + counted(check.particles, "cell") + ", ";
    line += check.open_cells == 0 ? "all closed" : counted(check.open_cells, "cell") + " not closed";
    return line + printed("; a ball of %.3g m/s breaks it", check.velocity);
}

}  // namespace

ModelCheck checkModel(const Shot& shot, const ProgressCallback& progress) {
    ModelCheck check;
    check.file = shot.model.string();
    try {
        ImportedModel model = readModel(shot.model, shot.part.node, progress);
        check.contents = model.contents;
        check.size_in_file = sizeOf(model.mesh);
        check.looks = model.looks;
        const auto mesh =
            makeSolidMesh(std::move(model.mesh), shot.model, placementOf(shot), std::move(model.looks));
        lookAtMesh(shot, *mesh, Advised::kTerminal, check);
        const FillOptions options{
            .particles = particlesWanted(shot, *mesh, false), .seed = shot.seed, .draw_geometry = false};
        lookAtBody(shot, *fillWithParticles(*mesh, options), check);
    } catch (const InputFileError& error) {
        check.refusal = error.what();
    }
    return check;
}

ModelCheck checkOf(const BuiltShot& built) {
    ModelCheck check;
    check.file = built.shot.model.string();
    const BodyFillings& cells = built.cells;
    const auto read = std::find_if(cells.meshes.begin(), cells.meshes.end(),
                                   [&](const auto& mesh) { return mesh.mesh == cells.subject_mesh; });
    if (read != cells.meshes.end()) {
        check.contents = read->contents;
        check.size_in_file = read->size_in_file;
    }
    if (const ModelLooks* looks = modelLooks(*cells.subject_mesh))
        check.looks = std::shared_ptr<const ModelLooks>(cells.subject_mesh, looks);
    lookAtMesh(built.shot, *cells.subject_mesh, Advised::kWindow, check);
    lookAtBody(built.shot, *cells.subject, check);
    return check;
}

LabelledLines checkLines(const ModelCheck& check) {
    LabelledLines lines;
    const auto say = [&lines](const char* label, const std::string& text) { lines.push_back({label, text}); };
    say("model", check.file);
    if (check.solid.triangles > 0) {
        const RepairReport& repair = check.repair;
        say("holds", counted(repair.triangles, "triangle") + ", " + counted(repair.parts, "part") + ", " +
                         counted(repair.open_edges, "open edge"));
        say("looks", looksLine(check));
        if (check.looks)
            for (const std::string& note : check.looks->notes) say("looks", note);
        say("size", sizeLine(check));
        say("overlaps",
            printed("%.2g %% of the volume", 100 * repair.overlap) + (repair.united > 0 ? ", united" : ""));
        for (const std::string& line : repairLines(repair)) say("repair", line);
        if (repair.untouched) say("repair", "none: taken as it is");
        say("body", printed("%zu triangles, %.3g m^3, %.3g x %.3g x %.3g m", check.solid.triangles,
                            check.solid.volume, check.solid.bounds_max.x - check.solid.bounds_min.x,
                            check.solid.bounds_max.y - check.solid.bounds_min.y,
                            check.solid.bounds_max.z - check.solid.bounds_min.z));
        if (check.spacing > 0) say("walls", wallLine(check));
    }
    say("breaks", breaksLine(check));
    return lines;
}

nlohmann::ordered_json checkJson(const ModelCheck& check) {
    const RepairReport& repair = check.repair;
    return {{"file", check.file},
            {"triangles", repair.triangles},
            {"vertices", repair.vertices},
            {"parts", repair.parts},
            {"open_edges", repair.open_edges},
            {"materials", check.contents.materials},
            {"textures", check.contents.textures},
            {"has_looks", check.looks != nullptr},
            {"vertex_colours", check.looks && check.looks->has_colours},
            {"looks_notes", check.looks ? check.looks->notes : std::vector<std::string>{}},
            {"unit_known", check.contents.is_in_metres},
            {"unit_m", check.contents.is_in_metres ? 1 : check.unit},
            {"size_remark", check.size_remark},
            {"size_in_file", {check.size_in_file.x, check.size_in_file.y, check.size_in_file.z}},
            {"overlap", repair.overlap},
            {"repair", repairLines(repair)},
            {"triangles_after", check.solid.triangles},
            {"volume_m3", check.solid.volume},
            {"thin_wall_m", check.thin_wall},
            {"particles", check.particles},
            {"particle_size_m", check.spacing},
            {"open_cells", check.open_cells},
            {"ball_velocity_mps", check.velocity},
            {"breaks", check.refusal.empty()},
            {"refusal", check.refusal}};
}

}  // namespace demolish
