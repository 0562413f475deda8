// Read-back and replay of the streams. The draw lists are large but change only while something breaks.
#include "app/session/recording.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <numbers>
#include <utility>

namespace demolish {
using engine::StreamId;
namespace {

template <class T>
std::vector<T> download(const engine::FractureMesh& mesh, StreamId id, size_t count) {
    const auto& buffer = mesh.stream(id);
    std::vector<T> values(std::min(count, buffer.size() / sizeof(T)));
    if (!values.empty()) buffer.download(std::as_writable_bytes(std::span(values)));
    return values;
}

template <class T>
void upload(engine::FractureMesh& mesh, StreamId id, const std::vector<T>& values) {
    if (!values.empty()) mesh.stream(id).upload(std::as_bytes(std::span(values)));
}

std::vector<std::byte> bytesOf(const std::vector<uint32_t>& values) {
    std::vector<std::byte> bytes(values.size() * sizeof(uint32_t));
    if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

Float3 moved(const FragmentTransform& motion, const Double3& rest) {
    const glm::quat rotation(motion.rotation.w, motion.rotation.x, motion.rotation.y, motion.rotation.z);
    const glm::vec3 turned = rotation * glm::vec3(rest.x, rest.y, rest.z);
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

}  // namespace

std::vector<uint8_t>* RecordedColours::of(ParticleColour channel) {
    switch (channel) {
        case ParticleColour::kDamage:
            return &damage;
        case ParticleColour::kStress:
            return &stress;
        case ParticleColour::kSpeed:
            return &speed;
        case ParticleColour::kFragment:
            break;
    }
    return nullptr;
}

std::vector<uint8_t> readColour(const engine::FractureMesh& mesh) {
    const auto instances = download<ParticleInstance>(mesh, StreamId::kParticles, mesh.particleCount());
    std::vector<uint8_t> values(instances.size());
    std::transform(instances.begin(), instances.end(), values.begin(), [](const ParticleInstance& instance) {
        return static_cast<uint8_t>(std::lround(255 * std::clamp(instance.value, 0.0f, 1.0f)));
    });
    return values;
}

size_t RecordedDrawList::bytes() const {
    return sizeof(*this) + damage.size() + 4 * (particle_fragment.size() + slots.size()) +
           interior_vertices.size() + interior_indices.size() + crack_edges.size();
}

void Recording::clear() {
    frames_.clear();
    bytes_ = 0;
}

std::shared_ptr<const RecordedDrawList> Recording::readDrawList(const engine::FractureMesh& mesh,
                                                                std::vector<uint8_t> damage) const {
    auto list = std::make_shared<RecordedDrawList>();
    list->particle_fragment = download<uint32_t>(mesh, StreamId::kParticleFragment, mesh.particleCount());
    list->damage = std::move(damage);
    list->slots = list->particle_fragment;
    std::sort(list->slots.begin(), list->slots.end());
    list->slots.erase(std::unique(list->slots.begin(), list->slots.end()), list->slots.end());
    list->commands = download<DrawCommands>(mesh, StreamId::kCommands, 1).at(0);
    const auto indices = download<uint32_t>(mesh, StreamId::kInteriorIndices, list->commands.interior.count);
    const size_t vertices =
        indices.empty() ? 0 : *std::max_element(indices.begin(), indices.end()) + size_t{1};
    list->interior_indices = bytesOf(indices);
    list->interior_vertices =
        download<std::byte>(mesh, StreamId::kInteriorVertices, vertices * sizeof(SurfaceVertex));
    list->crack_edges =
        bytesOf(download<uint32_t>(mesh, StreamId::kCrackEdges, list->commands.cracks.instance_count));
    return list;
}

void Recording::add(const engine::FractureMesh& mesh, std::span<const ParticleInstance> projectiles,
                    RecordedColours colours, const FrameStats& stats) {
    if (full()) return;
    RecordedFrame frame;
    const bool changed = breaksWith(stats);
    frame.draw_list = changed ? readDrawList(mesh, std::move(colours.damage)) : frames_.back().draw_list;
    frame.stress = std::move(colours.stress);
    frame.speed = std::move(colours.speed);
    const auto all = download<FragmentTransform>(mesh, StreamId::kTransforms, mesh.particleCount());
    frame.transforms.reserve(frame.draw_list->slots.size());
    for (const uint32_t slot : frame.draw_list->slots) frame.transforms.push_back(all[slot]);
    frame.projectiles.assign(projectiles.begin(), projectiles.end());
    frame.stats = stats;
    bytes_ += sizeof(frame) + frame.stress.size() + frame.speed.size() +
              frame.transforms.size() * sizeof(FragmentTransform) +
              frame.projectiles.size() * sizeof(ParticleInstance) + (changed ? frame.draw_list->bytes() : 0);
    frames_.push_back(std::move(frame));
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
    upload(mesh, StreamId::kInteriorVertices, list.interior_vertices);
    upload(mesh, StreamId::kInteriorIndices, list.interior_indices);
    upload(mesh, StreamId::kExteriorIndices, drawnExterior(setup, list.particle_fragment));
    upload(mesh, StreamId::kCrackEdges, list.crack_edges);
    upload(mesh, StreamId::kCommands, std::vector<DrawCommands>{list.commands});
}

}  // namespace demolish
