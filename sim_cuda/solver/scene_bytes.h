// SPDX-License-Identifier: Apache-2.0
// Everything on the device that changes while stepping, as bytes: its part of a snapshot.
#pragma once
#include <stdexcept>
#include <type_traits>

#include "sim_cuda/solver/byte_stream.h"
#include "sim_cuda/solver/checkpoint.h"

namespace demolish {

/// Waits.
template <class Backend, class Real>
void writeScene(ByteStream& out, DeviceScene<Backend, Real>& scene) {
    const auto& contacts = scene.lists.contacts();
    out.writeValue(contacts.used);
    out.writeValue(scene.lists.horizon());
    const auto write = [&](auto view) { out.writeVector(scene.backend.downloaded(view)); };
    visitFixedBuffers(scene, [&](auto& buffer) { write(buffer.view()); });
    write(contacts.neighbour.view().part(0, contacts.used));
    write(contacts.spring.view().part(0, contacts.used));
    scene.fragments.forEachClusters([&](auto& some) { out.writeVector(some.motion.saveState()); });
}

/// Throws std::out_of_range when the bytes are of another scene; part of them has been taken over then.
template <class Backend, class Real>
void readScene(ByteStream& in, DeviceScene<Backend, Real>& scene) {
    const auto used = in.readValue<uint32_t>();
    scene.lists.adopt(used, in.readValue<double>());
    const auto readInto = [&](auto span) {
        const auto values = in.readVector<std::remove_const_t<std::remove_reference_t<decltype(span[0])>>>();
        if (values.size() != span.size()) throw std::out_of_range("snapshot of another scene");
        scene.backend.upload(span, values.data(), values.size());
        scene.backend.synchronize();
    };
    visitFixedBuffers(scene, [&](auto& buffer) { readInto(buffer.span()); });
    auto& contacts = scene.lists.contacts();
    readInto(contacts.neighbour.span().part(0, contacts.used));
    readInto(contacts.spring.span().part(0, contacts.used));
    scene.fragments.forEachClusters(
        [&](auto& some) { some.motion.restoreState(in.readVector<std::byte>()); });
}

}  // namespace demolish
