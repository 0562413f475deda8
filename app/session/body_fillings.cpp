// SPDX-License-Identifier: Apache-2.0
#include "app/session/body_fillings.h"

#include <algorithm>
#include <limits>

#include "app/reading/model_reader.h"
#include "app/session/progress_part.h"
#include "app/session/shot_bodies.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

constexpr double kReadingShare = 0.07;  // of the bar

bool samePlacement(const MeshPlacement& a, const MeshPlacement& b) {
    return a.height == b.height && a.keep_units == b.keep_units && a.part == b.part && a.repair == b.repair;
}

const BodyFillings::ReadMesh* find(const std::vector<BodyFillings::ReadMesh>& meshes,
                                   const BodyFillings::ReadMesh& wanted) {
    const auto at = std::find_if(meshes.begin(), meshes.end(), [&](const auto& mesh) {
        return mesh.model == wanted.model && samePlacement(mesh.placement, wanted.placement);
    });
    return at == meshes.end() ? nullptr : &*at;
}

const BodyFillings::Filling* find(const std::vector<BodyFillings::Filling>& fillings,
                                  const BodyFillings::Filling& wanted) {
    const auto at = std::find_if(fillings.begin(), fillings.end(), [&](const auto& filling) {
        return filling.mesh == wanted.mesh && filling.options == wanted.options;
    });
    return at == fillings.end() ? nullptr : &*at;
}

/// Made of what is kept where it can be; the others have no mesh yet.
std::vector<BodyFillings::ReadMesh> meshesWanted(const std::vector<BodyFillings::ReadMesh>& of_body,
                                                 const BodyFillings* reuse) {
    std::vector<BodyFillings::ReadMesh> wanted;
    for (const BodyFillings::ReadMesh& mesh : of_body) {
        if (find(wanted, mesh) != nullptr) continue;
        const auto* kept = reuse != nullptr ? find(reuse->meshes, mesh) : nullptr;
        wanted.push_back(kept != nullptr ? *kept : mesh);
    }
    return wanted;
}

/// Each file is read once for all of its nodes that are wanted.
void readMissing(std::vector<BodyFillings::ReadMesh>& meshes, const ProgressCallback& progress) {
    for (const BodyFillings::ReadMesh& first : meshes) {
        if (first.mesh) continue;
        std::vector<BodyFillings::ReadMesh*> of_file;
        std::vector<std::string> nodes;
        for (BodyFillings::ReadMesh& mesh : meshes) {
            if (mesh.mesh || mesh.model != first.model) continue;
            of_file.push_back(&mesh);
            nodes.push_back(mesh.placement.part.node);
        }
        std::vector<ImportedModel> models = readModels(first.model, nodes, progress);
        for (size_t i = 0; i < models.size(); ++i) {
            of_file[i]->contents = models[i].contents;
            of_file[i]->size_in_file = sizeOf(models[i].mesh);
            of_file[i]->mesh = makeSolidMesh(std::move(models[i].mesh), of_file[i]->model,
                                             of_file[i]->placement, std::move(models[i].looks));
        }
    }
}

/// The mesh of each body.
std::vector<std::shared_ptr<const SolidMesh>> readMeshes(const Shot& shot, const BodyFillings* reuse,
                                                         const ProgressCallback& progress,
                                                         BodyFillings& made) {
    std::vector<BodyFillings::ReadMesh> bodies;
    for (const SceneBody& body : bodiesOf(shot))
        bodies.push_back({body.model.value_or(shot.model), placementOf(shot, body), nullptr});
    made.meshes = meshesWanted(bodies, reuse);
    readMissing(made.meshes, progress);
    std::vector<std::shared_ptr<const SolidMesh>> of_body;
    for (const BodyFillings::ReadMesh& body : bodies) of_body.push_back(find(made.meshes, body)->mesh);
    return of_body;
}

/// A slip that would otherwise go unseen.
void requirePaint(const Shot& shot, const std::vector<FillOptions>& options) {
    const bool is_used = std::any_of(options.begin(), options.end(),
                                     [](const FillOptions& of) { return of.painted.has_value(); });
    if (!shot.painted || is_used) return;
    throw InputFileError("Strength is to follow painted colours, and '" + shot.model.filename().string() +
                         "' has no colours at its vertices; export it with them.");
}

}  // namespace

Double3 sizeOf(const TriangleMesh& mesh) {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Double3 low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};
    for (const Double3& p : mesh.positions) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    if (mesh.positions.empty()) return {};
    return {high.x - low.x, high.y - low.y, high.z - low.z};
}

BodyFillings makeBodyFillings(const Shot& shot, bool on_gpu, bool draw_geometry, const BodyFillings* reuse,
                              const ProgressCallback& progress) {
    BodyFillings made;
    const auto mesh = readMeshes(shot, reuse, part(progress, 0, kReadingShare), made);
    const std::vector<SceneBody> bodies = bodiesOf(shot);
    std::vector<FillOptions> options;
    std::vector<uint32_t> particles;
    // Bodies meet with their outsides where they begin against each other.
    const bool needs_outsides = bodies.size() > 1 || shot.mortar.has_value();
    for (size_t b = 0; b < bodies.size(); ++b) {
        options.push_back(fillOptionsOf(shot, bodies[b], *mesh[b], on_gpu));
        options.back().draw_geometry = draw_geometry || needs_outsides;
        particles.push_back(options.back().particles);
    }
    requireFewEnough(particles);
    requirePaint(shot, options);
    for (size_t b = 0; b < bodies.size(); ++b) {
        BodyFillings::Filling wanted{mesh[b], options[b], nullptr};
        const auto* known = find(made.fillings, wanted);
        if (known == nullptr) {
            const double share = (1 - kReadingShare) / static_cast<double>(bodies.size()),
                         from = kReadingShare + static_cast<double>(b) * share;
            const auto* kept = reuse != nullptr ? find(reuse->fillings, wanted) : nullptr;
            wanted.body = kept != nullptr ? kept->body
                                          : fillWithParticles(*mesh[b], wanted.options,
                                                              part(progress, from, from + share));
            made.fillings.push_back(std::move(wanted));
            known = &made.fillings.back();
        }
        made.of_body.push_back(known->body);
    }
    made.subject = made.of_body[subjectOf(shot)];
    made.subject_mesh = mesh[subjectOf(shot)];
    return made;
}

}  // namespace demolish
