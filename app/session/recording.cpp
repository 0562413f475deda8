// SPDX-License-Identifier: Apache-2.0
// Copies and replay of the streams. The draw lists are large but change only while something breaks.
#include "app/session/recording.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <utility>

#include "app/bridge/stream_layout.h"
#include "engine/render/fracture_mesh.h"

namespace demolish {
using engine::StreamId;
namespace {

template <class T>
std::span<const T> seen(const ReadStream& read, StreamId id, size_t count) {
    if (count == 0) return {};
    return {reinterpret_cast<const T*>(read(id, 0, count * sizeof(T)).data()), count};
}

template <class T>
std::vector<T> copied(std::span<const T> values) {
    return {values.begin(), values.end()};
}

template <class T>
void upload(engine::FractureMesh& mesh, StreamId id, std::span<const T> values) {
    if (!values.empty()) mesh.stream(id).upload(std::as_bytes(values));
}
template <class T>
void upload(engine::FractureMesh& mesh, StreamId id, const std::vector<T>& values) {
    upload(mesh, id, std::span<const T>(values));
}

Float3 moved(const FragmentTransform& motion, const Double3& rest) {
    const glm::quat rotation(motion.rotation.w, motion.rotation.x, motion.rotation.y, motion.rotation.z);
    const float scale = 1 - kShrinkStep * static_cast<float>(motion.shrink);
    const glm::vec3 turned = rotation * (scale * glm::vec3(rest.x, rest.y, rest.z));
    return {turned.x + motion.translation.x, turned.y + motion.translation.y,
            turned.z + motion.translation.z};
}

std::vector<ParticleInstance> instancesOf(const RecordedFrame& frame,
                                          const std::vector<FragmentTransform>& transforms,
                                          const SceneSetup& setup, std::span<const uint8_t> values) {
    std::vector<ParticleInstance> instances;
    instances.reserve(frame.draw_list->particle_fragment.size() + frame.projectiles.size());
    for (const BodyInstance& instance : setup.bodies)
        for (const Particle& particle : instance.body->particles) {
            const uint32_t slot = frame.draw_list->particle_fragment[instances.size()];
            const auto radius = static_cast<float>(std::cbrt(3 * particle.volume / (4 * std::numbers::pi)));
            const float value = values.empty() ? 0.0f : static_cast<float>(values[instances.size()]) / 255.0f;
            instances.push_back({moved(transforms[slot], particle.seed), radius, value, slot, {}});
        }
    instances.insert(instances.end(), frame.projectiles.begin(), frame.projectiles.end());
    return instances;
}

/// Empty for kFragment, which needs no values.
std::span<const uint8_t> valuesOf(const RecordedFrame& frame, ParticleColour colour) {
    switch (colour) {
        case ParticleColour::kDamage:
            return frame.draw_list->damage;
        case ParticleColour::kStress:
            return frame.stress;
        case ParticleColour::kSpeed:
            return frame.speed;
        case ParticleColour::kFragment:
            break;
    }
    return {};
}

/// A fragment's slot is its lowest particle.
std::vector<uint32_t> slotsOf(std::span<const uint32_t> particle_fragment) {
    std::vector<uint32_t> slots;
    for (uint32_t i = 0; i < particle_fragment.size(); ++i)
        if (particle_fragment[i] == i) slots.push_back(i);
    return slots;
}

/// What draws the surface, where the bridge has it.
struct SurfaceSpans {
    std::span<const SurfaceVertex> vertices;
    std::span<const uint32_t> indices;

    SurfaceSpans(const ReadStream& read, const DrawCommands& commands)
        : indices(seen<uint32_t>(read, StreamId::kInteriorIndices, commands.interior.count)) {
        vertices = seen<SurfaceVertex>(read, StreamId::kInteriorVertices,
                                       drawListUse(commands, indices).interior_vertices);
    }
    size_t bytes() const { return vertices.size_bytes() + indices.size_bytes(); }
};

}  // namespace

void Recording::clear() {
    finishCopies();
    effects_.clear();
    frames_.clear();
    bytes_ = 0;
}

void Recording::add(RecordedFrame frame) {
    if (full()) return;
    const bool changed = frames_.empty() || frames_.back().draw_list != frame.draw_list;
    const bool opened = frames_.empty() || frames_.back().crack_lines != frame.crack_lines;
    bytes_ += (opened ? frame.crack_lines->size() * sizeof(CrackLine) : 0) + sizeof(frame) +
              frame.stress.size() + frame.speed.size() + frame.transforms.size() * sizeof(FragmentTransform) +
              frame.projectiles.size() * sizeof(ParticleInstance) + (changed ? frame.draw_list->bytes : 0) +
              (frame.effects ? frame.effects->bytes() : 0);
    frames_.push_back(std::move(frame));
}

std::shared_ptr<const RecordedDrawList> Recording::readDrawList(const ReadStream& read,
                                                                std::span<const uint8_t> damage,
                                                                size_t outside_vertices) {
    auto list = std::make_shared<RecordedDrawList>();
    list->particle_fragment = copied(seen<uint32_t>(read, StreamId::kParticleFragment, damage.size()));
    list->damage = copied(damage);
    list->slots = slotsOf(list->particle_fragment);
    list->commands = seen<DrawCommands>(read, StreamId::kCommands, 1)[0];
    const SurfaceSpans surface(read, list->commands);
    list->outside = RecordedOutside(frames_.empty() ? nullptr : &frames_.back().draw_list->outside, read,
                                    outside_vertices);
    list->bytes = sizeof(*list) + damage.size() + surface.bytes() + list->outside.ownBytes() +
                  sizeof(uint32_t) * (list->particle_fragment.size() + list->slots.size());
    finishCopies();
    copying_ = std::async(std::launch::async, [list, surface] {
        list->interior_vertices = RecordedArray(surface.vertices);
        list->interior_indices = RecordedArray(surface.indices);
    });
    return list;
}

RecordedFrame Recording::read(FrameChange change, const ReadStream& stream, const ColourBytes& colours,
                              const FrameStats& stats, size_t outside_vertices) {
    RecordedFrame frame;
    frame.stats = stats;
    if (change == FrameChange::kProjectiles) {
        const RecordedFrame& before = frames_.back();
        frame.draw_list = before.draw_list;
        frame.transforms = before.transforms;
        frame.crack_lines = before.crack_lines;
        frame.stress = before.stress;
        frame.speed = before.speed;
        frame.effects = effects_.recordSame();
        return frame;
    }
    const size_t particles = colours.stress.size();
    frame.draw_list =
        breaksWith(stats) ? readDrawList(stream, colours.damage, outside_vertices) : frames_.back().draw_list;
    frame.crack_lines = readCracks(stream, frame.draw_list->commands);
    frame.stress = copied(colours.stress);
    frame.speed = copied(colours.speed);
    const auto all = seen<FragmentTransform>(stream, StreamId::kTransforms, particles);
    frame.transforms.reserve(frame.draw_list->slots.size());
    for (const uint32_t slot : frame.draw_list->slots) frame.transforms.push_back(all[slot]);
    frame.effects = readEffects(stream, stats);
    return frame;
}

std::shared_ptr<const std::vector<CrackLine>> Recording::readCracks(const ReadStream& read,
                                                                    const DrawCommands& commands) const {
    const auto lines = seen<CrackLine>(read, StreamId::kCrackEdges, commands.cracks.instance_count);
    if (!frames_.empty() && std::ranges::equal(*frames_.back().crack_lines, lines))
        return frames_.back().crack_lines;
    return std::make_shared<const std::vector<CrackLine>>(copied(lines));
}

std::shared_ptr<const RecordedEffects> Recording::readEffects(const ReadStream& read,
                                                              const FrameStats& stats) {
    EffectCommands commands{};
    if (stats.effects_shown) commands = seen<EffectCommands>(read, StreamId::kEffectCommands, 1)[0];
    // A GPU is not asked whether anything has been born yet.
    if (commands.grains.instance_count + commands.puffs.instance_count == 0) {
        effects_.clear();
        return nullptr;
    }
    return effects_.record(seen<GrainInstance>(read, StreamId::kGrains, commands.grains.instance_count),
                           seen<PuffInstance>(read, StreamId::kPuffs, commands.puffs.instance_count));
}

void Recording::replayEffects(size_t index, engine::FractureMesh& mesh) const {
    const bool shown = frames_[index].effects != nullptr;
    mesh.showEffects(shown, frames_[index].stats.effects_moving);
    if (!shown) return;
    size_t first = index;
    while (!frames_[first].effects->isWhole()) --first;
    std::vector<GrainInstance> grains;
    std::vector<PuffInstance> puffs;
    for (size_t k = first; k <= index; ++k) frames_[k].effects->apply(grains, puffs);
    upload(mesh, StreamId::kGrains, grains);
    upload(mesh, StreamId::kPuffs, puffs);
    upload(mesh, StreamId::kEffectCommands,
           std::vector<EffectCommands>{
               effectCommands(static_cast<uint32_t>(grains.size()), static_cast<uint32_t>(puffs.size()))});
}

void Recording::replay(size_t index, engine::FractureMesh& mesh, const SceneSetup& setup,
                       ParticleColour colour) const {
    const RecordedFrame& frame = frames_[index];
    const RecordedDrawList& list = *frame.draw_list;
    std::vector<FragmentTransform> transforms(mesh.particleCount());
    for (size_t i = 0; i < list.slots.size(); ++i) transforms[list.slots[i]] = frame.transforms[i];
    upload(mesh, StreamId::kTransforms, transforms);
    upload(mesh, StreamId::kParticles, instancesOf(frame, transforms, setup, valuesOf(frame, colour)));
    upload(mesh, StreamId::kParticleFragment, list.particle_fragment);
    upload(mesh, StreamId::kInteriorVertices, list.interior_vertices.span());
    upload(mesh, StreamId::kInteriorIndices, list.interior_indices.span());
    list.outside.upload(mesh);
    upload(mesh, StreamId::kExteriorIndices, drawnExterior(setup, list.particle_fragment));
    upload(mesh, StreamId::kCrackEdges, *frame.crack_lines);
    upload(mesh, StreamId::kCommands, std::vector<DrawCommands>{list.commands});
    replayEffects(index, mesh);
}

}  // namespace demolish
