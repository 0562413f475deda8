// SPDX-License-Identifier: Apache-2.0
// Everything that changes while stepping, set aside on the device (frame start, dry runs) or as bytes
// (snapshots).
#pragma once
#include <cstring>
#include <vector>

#include "sim_cuda/solver/neighbour_lists.h"
#include "sim_cuda/solver/regimes.h"
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// Calls visit(buffer) for every changing buffer whose size never changes.
template <class Data, class Lists, class Regimes, class Visit>
void visitFixedBuffers(Data& data, Lists& lists, Regimes& regimes, const Visit& visit) {
    auto& particles = data.particles;
    const uint32_t current = data.current;
    visit(particles.position[current]);
    visit(particles.rotation[current]);
    visit(particles.velocity[current]);
    visit(particles.spin[current]);
    visit(particles.constants);
    visit(data.bonds.link);
    visit(data.bonds.spring);
    visit(data.plane_spring);
    visit(data.ledger);
    visit(lists.contacts().row_start);
    visit(lists.contacts().built_position);
    visit(lists.contacts().built_velocity);
    regimes.visitBuffers(visit);
}

/// Bytes that grow as they are written and are read back in the same order.
class ByteStream {
  public:
    ByteStream() = default;
    explicit ByteStream(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

    void write(const void* from, size_t count) {
        const auto* first = static_cast<const std::byte*>(from);
        bytes_.insert(bytes_.end(), first, first + count);
    }
    /// Throws std::out_of_range when the bytes end before.
    void read(void* to, size_t count) {
        if (count > bytes_.size() - position_) throw std::out_of_range("snapshot is too short");
        if (count > 0) std::memcpy(to, bytes_.data() + position_, count);
        position_ += count;
    }
    template <class T>
    void writeValue(const T& value) {
        write(&value, sizeof(T));
    }
    template <class T>
    T readValue() {
        T value;
        read(&value, sizeof(T));
        return value;
    }
    template <class T>
    void writeVector(const std::vector<T>& values) {
        writeValue<uint64_t>(values.size());
        write(values.data(), values.size() * sizeof(T));
    }
    template <class T>
    std::vector<T> readVector() {
        const uint64_t count = readValue<uint64_t>();
        if (count > (bytes_.size() - position_) / sizeof(T)) throw std::out_of_range("snapshot is too short");
        std::vector<T> values(count);
        read(values.data(), count * sizeof(T));
        return values;
    }
    bool atEnd() const { return position_ == bytes_.size(); }
    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
    size_t position_ = 0;
};

/// A copy on the device.
template <class Backend, class Real>
class Checkpoint {
  public:
    template <class T>
    using Buffer = typename Backend::template Buffer<T>;

    void keep(Backend& backend, SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
              Regimes<Backend, Real>& regimes) {
        current_ = data.current;
        used_ = lists.contacts().used;
        horizon_ = lists.horizon();
        size_t place = 0;
        visitAll(data, lists, regimes, [&](auto span) {
            const Span<unsigned char> bytes = bytesOf(span);
            backend.copy(Span<const unsigned char>(bytes), room(backend, place++, bytes.count));
        });
    }

    void putBack(Backend& backend, SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                 Regimes<Backend, Real>& regimes) {
        data.current = current_;
        lists.adopt(used_, horizon_);
        size_t place = 0;
        visitAll(data, lists, regimes, [&](auto span) {
            const Span<unsigned char> bytes = bytesOf(span);
            backend.copy(buffers_[place++].view().part(0, bytes.count), bytes);
        });
    }

  private:
    /// Calls visit(span) for everything, always in the same order.
    template <class Visit>
    void visitAll(SolverData<Backend, Real>& data, NeighbourLists<Backend, Real>& lists,
                  Regimes<Backend, Real>& regimes, const Visit& visit) {
        visitFixedBuffers(data, lists, regimes, [&](auto& buffer) { visit(buffer.span()); });
        auto& contacts = lists.contacts();
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

    std::vector<Buffer<unsigned char>> buffers_;
    uint32_t current_ = 0, used_ = 0;
    double horizon_ = 0;
};

}  // namespace demolish
