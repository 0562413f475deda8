// SPDX-License-Identifier: Apache-2.0
// Sums over cells; whole frames in memory that either device can write.
#include "tests/fuzz/shots/frame_checks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <sstream>
#include <stdexcept>

#if defined(DEMOLISH_WITH_CUDA)
#include <cuda_runtime_api.h>
#endif

namespace demolish::fuzz {
namespace {

constexpr double kVolumeTolerance = 1e-4, kMassTolerance = 1e-5;

std::string differs(const char* what, double is, double should_be) {
    std::ostringstream text;
    text.precision(9);
    text << what << " is " << is << ", not " << should_be;
    return text.str();
}

bool near(double is, double should_be, double tolerance) {
    return std::abs(is - should_be) <= tolerance * std::abs(should_be);
}

using Bytes = std::unique_ptr<void, void (*)(void*)>;

/// A GPU cannot write into plain host memory: pinned memory is seen by both.
Bytes memoryOf(size_t bytes, [[maybe_unused]] bool on_gpu) {
#if defined(DEMOLISH_WITH_CUDA)
    if (on_gpu) {
        void* memory = nullptr;
        if (cudaMallocHost(&memory, bytes) != cudaSuccess) throw std::runtime_error("no pinned memory");
        return {memory, [](void* pinned) { cudaFreeHost(pinned); }};
    }
#endif
    return {::operator new(bytes), [](void* plain) { ::operator delete(plain); }};
}

/// Memory of one stream.
template <class T>
class StreamMemory {
  public:
    StreamMemory(size_t count, bool on_gpu)
        : count_(count), bytes_(memoryOf(std::max<size_t>(1, count) * sizeof(T), on_gpu)) {}
    Stream<T> stream() const { return {static_cast<T*>(bytes_.get()), count_}; }
    std::span<const T> first(size_t count) const {
        return {static_cast<const T*>(bytes_.get()), std::min(count, count_)};
    }

  private:
    size_t count_;
    Bytes bytes_;
};

bool finite(const Float3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool finite(const Float4& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z) && std::isfinite(v.w);
}

/// One frame of the solver, whole.
struct WholeFrame {
    WholeFrame(const StreamSizes& sizes, size_t particle_count, bool on_gpu)
        : particles(sizes.particles, on_gpu),
          fragments(particle_count, on_gpu),
          transforms(sizes.particles, on_gpu),
          vertices(sizes.interior_vertices, on_gpu),
          indices(sizes.interior_indices, on_gpu),
          exterior(sizes.exterior_indices, on_gpu),
          cracks(sizes.crack_edges, on_gpu),
          commands(1, on_gpu),
          damage(particle_count, on_gpu),
          stress(particle_count, on_gpu),
          speed(particle_count, on_gpu) {}

    /// Cells without draw geometry have no streams of a surface.
    RenderStreams streams(bool has_surface) const {
        RenderStreams all;
        all.particles = particles.stream();
        all.particle_fragment = fragments.stream();
        all.transforms = transforms.stream();
        all.colours = {damage.stream(), stress.stream(), speed.stream()};
        if (!has_surface) return all;
        all.interior_vertices = vertices.stream();
        all.interior_indices = indices.stream();
        all.exterior_indices = exterior.stream();
        all.crack_edges = cracks.stream();
        all.commands = commands.stream();
        return all;
    }

    StreamMemory<ParticleInstance> particles;
    StreamMemory<uint32_t> fragments;
    StreamMemory<FragmentTransform> transforms;
    StreamMemory<SurfaceVertex> vertices;
    StreamMemory<uint32_t> indices, exterior;
    StreamMemory<CrackLine> cracks;
    StreamMemory<DrawCommands> commands;
    StreamMemory<uint8_t> damage, stress, speed;
};

/// The first few; one is enough to look for the cause.
class Faults {
  public:
    void add(const char* what, size_t index) {
        if (sentences_.size() < 4) sentences_.push_back(what + std::string(" ") + std::to_string(index));
    }
    std::vector<std::string> sentences() const { return sentences_; }

  private:
    std::vector<std::string> sentences_;
};

void checkParticles(const WholeFrame& frame, size_t count, uint32_t projectiles, Faults& faults) {
    const auto particles = frame.particles.first(count + projectiles);
    for (size_t i = 0; i < particles.size(); ++i) {
        const ParticleInstance& p = particles[i];
        if (!finite(p.position) || !std::isfinite(p.radius)) faults.add("not finite: particle", i);
        if (!(p.value >= 0 && p.value <= 1)) faults.add("colour out of 0..1: particle", i);
    }
    const auto fragments = frame.fragments.first(count);
    const auto transforms = frame.transforms.first(count);
    for (size_t i = 0; i < count; ++i) {
        const uint32_t slot = fragments[i];
        if (slot > i || fragments[slot] != slot)
            faults.add("no slot of a fragment: particle", i);
        else if (!finite(transforms[slot].rotation) || !finite(transforms[slot].translation))
            faults.add("not finite: fragment", slot);
    }
}

void checkSurface(const WholeFrame& frame, const StreamSizes& sizes, size_t count, Faults& faults) {
    const DrawCommands& commands = frame.commands.first(1)[0];
    if (commands.interior.count > sizes.interior_indices ||
        commands.exterior.count > sizes.exterior_indices ||
        commands.cracks.instance_count > sizes.crack_edges)
        return faults.add("more to draw than there is: interior indices", commands.interior.count);
    const auto vertices = frame.vertices.first(sizes.interior_vertices);
    for (const uint32_t index : frame.indices.first(commands.interior.count)) {
        if (index >= vertices.size())
            faults.add("beyond the vertices: interior index", index);
        else if (!finite(vertices[index].position) || vertices[index].cell >= count)
            faults.add("not finite, or of no cell: interior vertex", index);
    }
}

}  // namespace

std::vector<std::string> faultsOfBody(const BuiltShot& built) {
    std::vector<std::string> faults;
    double mass = 0;
    size_t particles = 0;
    for (const BodyFillings::Filling& filling : built.cells.fillings) {
        const double volume = meshInfo(*filling.mesh).volume;
        // What is simulated may be a turned copy of it.
        for (size_t b = 0; b < built.setup.bodies.size(); ++b) {
            if (built.cells.of_body.at(b) != filling.body) continue;
            mass += built.setup.bodies[b].material.density * volume;
            particles += filling.options.particles;
        }
        double cells = 0;
        for (const Particle& particle : filling.body->particles) cells += particle.volume;
        if (!near(cells, volume, kVolumeTolerance))
            faults.push_back(differs("the volume of all cells", cells, volume));
        if (filling.body->particles.size() != filling.options.particles)
            faults.push_back(differs("the number of cells",
                                     static_cast<double>(filling.body->particles.size()),
                                     static_cast<double>(filling.options.particles)));
    }
    const FrameStats& stats = built.solver->stats();
    if (!near(stats.mass, mass, kMassTolerance)) faults.push_back(differs("the mass", stats.mass, mass));
    if (stats.particles != particles)
        faults.push_back(differs("the number of particles", stats.particles, static_cast<double>(particles)));
    return faults;
}

std::vector<std::string> faultsOfFrame(const BuiltShot& built, uint32_t projectiles, ParticleColour colour) {
    const StreamSizes sizes = streamSizes(built.setup);
    const size_t count = built.solver->stats().particles;
    const WholeFrame frame(sizes, count, built.solver->onGpu());
    RenderStreams streams = frame.streams(built.has_draw_geometry);
    streams.colour = colour;
    built.solver->exportFrame(streams, true);
    built.solver->synchronize();
    Faults faults;
    checkParticles(frame, count, projectiles, faults);
    if (built.has_draw_geometry) checkSurface(frame, sizes, count, faults);
    return faults.sentences();
}

}  // namespace demolish::fuzz
