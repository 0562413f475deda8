// SPDX-License-Identifier: Apache-2.0
#include "app/session/shot_bodies.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/session/ball_flight.h"
#include "engine/scene/frame_view.h"
#include "sim_cuda/api/errors.h"

namespace demolish {
namespace {

bool madeAlike(const SceneBody& a, const SceneBody& b) {
    return a.height_share == b.height_share && a.keeps_size == b.keeps_size && a.breaks == b.breaks &&
           a.particles_share == b.particles_share && a.particle_size == b.particle_size &&
           a.model == b.model && a.part == b.part && a.material == b.material;
}

/// Beyond all that a scene may have: what no look of a view stands for is not drawn.
constexpr uint32_t kHiddenLook = engine::kMostLooks - 1;

/// Of bodies that say nothing about it.
uint32_t usualParticles(const Shot& shot, bool on_gpu) {
    const Fineness& fine = shot.fineness;
    return fine.particles ? *fine.particles : on_gpu ? fine.full : fine.draft;
}

}  // namespace

std::vector<SceneBody> bodiesOf(const Shot& shot) {
    if (!shot.bodies.empty()) return shot.bodies;
    SceneBody body;
    body.keeps_size = shot.keeps_size;
    return {body};
}

std::vector<size_t> firstAlike(const std::vector<SceneBody>& bodies) {
    std::vector<size_t> first, kinds;
    for (size_t i = 0; i < bodies.size(); ++i) {
        const auto known = std::find_if(kinds.begin(), kinds.end(),
                                        [&](size_t kind) { return madeAlike(bodies[kind], bodies[i]); });
        first.push_back(known == kinds.end() ? i : *known);
        if (first[i] == i) kinds.push_back(i);
    }
    return first;
}

size_t subjectOf(const Shot& shot) {
    const std::vector<size_t> first = firstAlike(bodiesOf(shot));
    return first[std::min<size_t>(fastestBall(shot).body, first.size() - 1)];
}

ModelPart partOf(const Shot& shot, const SceneBody& body) {
    if (body.part) return *body.part;
    return body.model ? ModelPart{"", shot.part.up} : shot.part;
}

Shot asOf(const Shot& shot, const SceneBody& body) {
    Shot of = shot;
    if (body.model) of.model = *body.model;
    of.part = partOf(shot, body);
    if (body.model || body.part) of.strength_row.clear();
    if (body.material) {
        of.material_name = body.material->name;
        of.material = body.material->material;
        of.look = body.material->look;
    }
    return of;
}

MeshPlacement placementOf(const Shot& shot, const SceneBody& body) {
    return {.height = shot.height * body.height_share,
            .keep_units = body.keeps_size,
            .part = partOf(shot, body),
            .repair = shot.repair};
}
MeshPlacement placementOf(const Shot& shot) {
    return placementOf(shot, bodiesOf(shot)[subjectOf(shot)]);
}

uint32_t particlesWanted(const Shot& shot, const SceneBody& body, const SolidMesh& mesh, bool on_gpu) {
    if (shot.fineness.particle_size) return particlesForSize(mesh, *shot.fineness.particle_size);
    const double usual = usualParticles(shot, on_gpu);
    if (body.particle_size)
        return particlesForSize(
            mesh, body.particle_size->metres * std::cbrt(body.particle_size->usual_particles / usual));
    if (body.particles_share == 1) return static_cast<uint32_t>(usual);
    const double wanted = std::max(std::round(body.particles_share * usual), double{kMinParticles});
    requireInRange("the number of particles of a body", wanted, {kMinParticles, kMaxParticles}, "");
    return static_cast<uint32_t>(wanted);
}
uint32_t particlesWanted(const Shot& shot, const SolidMesh& mesh, bool on_gpu) {
    return particlesWanted(shot, bodiesOf(shot)[subjectOf(shot)], mesh, on_gpu);
}

bool laysToughCells(const Shot& shot) {
    return shot.conform || (shot.pattern && !traitsOf(shot.method).pattern_turns);
}

FillOptions fillOptionsOf(const Shot& shot, const SceneBody& body, const SolidMesh& mesh, bool on_gpu) {
    FillOptions options;
    options.particles = particlesWanted(shot, body, mesh, on_gpu);
    options.seed = shot.seed + body.variant;
    const bool has_pattern = shot.pattern && !traitsOf(shot.method).pattern_turns;
    if (!body.breaks) return options;
    options.refine = shot.refine;
    if (const ModelLooks* looks = modelLooks(mesh); looks != nullptr && looks->has_colours)
        options.painted = shot.painted;
    if (options.refine > 1 || (has_pattern && *shot.pattern == Pattern::kRadial))
        options.aim = aimOf(shot, body, meshInfo(mesh));
    if (!laysToughCells(shot)) return options;
    ToughCellOptions& tough = options.tough.emplace();
    tough.cells = asOf(shot, body).material.tough_cells;
    tough.conform = shot.conform;
    if (!has_pattern) return options;
    tough.pattern = shot.pattern;
    if (shot.pattern_axis)
        tough.axis = *shot.pattern_axis;
    else if (*shot.pattern == Pattern::kRadial)
        tough.axis = options.aim.way;
    return options;
}

void requireFewEnough(const std::vector<uint32_t>& particles) {
    const uint64_t sum = std::accumulate(particles.begin(), particles.end(), uint64_t{0});
    if (sum <= kMaxSceneParticles) return;
    const auto [least, most] = std::minmax_element(particles.begin(), particles.end());
    const std::string count = std::to_string(particles.size()),
                      numbers = *least == *most ? std::to_string(*most)
                                                : std::to_string(*least) + " to " + std::to_string(*most);
    throw UsageError(count + " bodies of " + numbers + " particles are " + std::to_string(sum) +
                     "; at most " + std::to_string(kMaxSceneParticles) + " are possible: choose at most " +
                     std::to_string(kMaxSceneParticles / particles.size()) + " of each body");
}

ShotLooks looksOf(const Shot& shot) {
    ShotLooks result{{shot.look}, {}, {}};
    const std::vector<SceneBody> bodies = bodiesOf(shot);
    std::vector<const OwnMaterial*> known{nullptr};
    for (const SceneBody& body : bodies) {
        const auto found = std::find_if(known.begin(), known.end(), [&](const OwnMaterial* material) {
            return material == nullptr ? !body.material : body.material && *material == *body.material;
        });
        result.of_body.push_back(body.hidden ? kHiddenLook : static_cast<uint32_t>(found - known.begin()));
        if (found != known.end()) continue;
        known.push_back(&*body.material);
        result.looks.push_back(body.material->look);
    }
    const bool any_hidden = std::any_of(bodies.begin(), bodies.end(), [](const auto& b) { return b.hidden; });
    if (any_hidden && !result.areSeveral()) result.looks.push_back(shot.look);  // look by look, then
    for (uint32_t look = 0; look < result.looks.size(); ++look) {
        const auto at = std::find(result.of_body.begin(), result.of_body.end(), look);
        result.example.push_back(
            at == result.of_body.end() ? 0 : static_cast<size_t>(at - result.of_body.begin()));
    }
    return result;
}

std::string nameOf(const Shot& shot, size_t body) {
    const std::vector<SceneBody> bodies = bodiesOf(shot);
    const SceneBody& of = bodies.at(body);
    if (!of.name.empty()) return of.name;
    const std::string& node = partOf(shot, of).node;
    const std::string name = node.empty() ? of.model.value_or(shot.model).stem().string() : node;
    return bodies.size() == 1 ? name : name + " " + std::to_string(body);
}

}  // namespace demolish
