// SPDX-License-Identifier: Apache-2.0
// Bytes that grow as they are written and are read back in the same order: what snapshots are made of.
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <utility>
#include <vector>

namespace demolish {

class ByteStream {
  public:
    ByteStream() = default;
    explicit ByteStream(std::vector<std::byte> bytes) : bytes_(std::move(bytes)) {}

    void write(const void* from, size_t count) {
        const size_t end = bytes_.size();
        bytes_.resize(end + count);
        if (count > 0) std::memcpy(bytes_.data() + end, from, count);
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

}  // namespace demolish
