// SPDX-License-Identifier: Apache-2.0
#include "app/session/body_fillings.h"

#include <algorithm>

#include "app/reading/model_reader.h"
#include "app/session/progress_part.h"
#include "app/session/shot_bodies.h"

namespace demolish {
namespace {

constexpr double kReadingShare = 0.07;  // of the bar

bool samePlacement(const MeshPlacement& a, const MeshPlacement& b) {
    return a.height == b.height && a.keep_units == b.keep_units && a.part == b.part && a.repair == b.repair;
}
bool sameOptions(const FillOptions& a, const FillOptions& b) {
    return a.particles == b.particles && a.seed == b.seed && a.draw_geometry == b.draw_geometry;
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
        return filling.mesh == wanted.mesh && sameOptions(filling.options, wanted.options);
    });
    return at == fillings.end() ? nullptr : &*at;
}

/// The mesh of each body.
std::vector<std::shared_ptr<const SolidMesh>> readMeshes(const Shot& shot, const BodyFillings* reuse,
                                                         const ProgressCallback& progress,
                                                         BodyFillings& made) {
    std::vector<std::shared_ptr<const SolidMesh>> of_body;
    for (const SceneBody& body : bodiesOf(shot)) {
        BodyFillings::ReadMesh wanted{body.model.value_or(shot.model), placementOf(shot, body), nullptr};
        if (const auto* known = find(made.meshes, wanted)) {
            of_body.push_back(known->mesh);
            continue;
        }
        const auto* kept = reuse != nullptr ? find(reuse->meshes, wanted) : nullptr;
        wanted.mesh = kept != nullptr ? kept->mesh : readSolidMesh(wanted.model, wanted.placement, progress);
        of_body.push_back(wanted.mesh);
        made.meshes.push_back(std::move(wanted));
    }
    return of_body;
}

}  // namespace

BodyFillings makeBodyFillings(const Shot& shot, bool on_gpu, bool draw_geometry, const BodyFillings* reuse,
                              const ProgressCallback& progress) {
    BodyFillings made;
    const auto mesh = readMeshes(shot, reuse, part(progress, 0, kReadingShare), made);
    const std::vector<SceneBody> bodies = bodiesOf(shot);
    std::vector<uint32_t> particles;
    for (size_t b = 0; b < bodies.size(); ++b)
        particles.push_back(particlesWanted(shot, bodies[b], *mesh[b], on_gpu));
    requireFewEnough(particles);
    for (size_t b = 0; b < bodies.size(); ++b) {
        BodyFillings::Filling wanted{mesh[b],
                                     {.particles = particles[b],
                                      .seed = shot.seed + bodies[b].variant,
                                      .draw_geometry = draw_geometry},
                                     nullptr};
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
