// SPDX-License-Identifier: Apache-2.0
// Everything that changes while stepping, set aside on the device: the start of a frame, dry runs.
#pragma once
#include <vector>

#include "sim_cuda/solver/device_scene.h"

namespace demolish {

/// Calls visit(buffer) for every changing buffer whose size never changes.
template <class Backend, class Real, class Visit>
void visitFixedBuffers(DeviceScene<Backend, Real>& scene, const Visit& visit) {
    auto& particles = scene.data.particles;
    const uint32_t current = scene.data.current;
    visit(particles.position[current]);
    visit(particles.rotation[current]);
    visit(particles.velocity[current]);
    visit(particles.spin[current]);
    visit(particles.constants);
    visit(scene.data.bonds.link);
    visit(scene.data.bonds.spring);
    visit(scene.data.collider_spring);
    visit(scene.data.ledger);
    visit(scene.lists.contacts().row_start);
    visit(scene.lists.contacts().built_position);
    visit(scene.lists.contacts().built_velocity);
    scene.regimes.visitBuffers(visit);
    scene.release.visitBuffers(visit);
}

/// A copy on the device; it owns its memory, and keeps it for the next one.
template <class Backend, class Real>
class Checkpoint {
  public:
    using Scene = DeviceScene<Backend, Real>;

    void keep(Scene& scene) {
        current_ = scene.data.current;
        used_ = scene.lists.contacts().used;
        horizon_ = scene.lists.horizon();
        size_t place = 0;
        visitAll(scene, [&](auto span) {
            const Span<unsigned char> bytes = bytesOf(span);
            scene.backend.copy(Span<const unsigned char>(bytes), room(scene.backend, place++, bytes.count));
        });
    }

    void putBack(Scene& scene) {
        scene.data.current = current_;
        scene.lists.adopt(used_, horizon_);
        scene.held.forgetFormer(scene.data);
        size_t place = 0;
        visitAll(scene, [&](auto span) {
            const Span<unsigned char> bytes = bytesOf(span);
            scene.backend.copy(buffers_[place++].view().part(0, bytes.count), bytes);
        });
    }

  private:
    /// Calls visit(span) for everything, always in the same order.
    template <class Visit>
    void visitAll(Scene& scene, const Visit& visit) {
        visitFixedBuffers(scene, [&](auto& buffer) { visit(buffer.span()); });
        auto& contacts = scene.lists.contacts();
        visit(contacts.neighbour.span().part(0, used_));
        visit(contacts.spring.span().part(0, used_));
    }
    template <class T>
    static Span<unsigned char> bytesOf(Span<T> span) {
        return {reinterpret_cast<unsigned char*>(span.data), span.count * sizeof(T)};
    }
    Span<unsigned char> room(Backend& backend, size_t place, size_t bytes) {
        if (buffers_.size() <= place) buffers_.resize(place + 1);
        if (buffers_[place].size() < bytes) {
            backend.synchronize();
            buffers_[place] = backend.template allocate<unsigned char>(bytes + bytes / 4);
        }
        return buffers_[place].span().part(0, bytes);
    }

    std::vector<typename Backend::template Buffer<unsigned char>> buffers_;
    uint32_t current_ = 0, used_ = 0;
    double horizon_ = 0;
};

}  // namespace demolish
