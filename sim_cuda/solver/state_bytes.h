// Snapshots as bytes: plain values written one after the other and read back in the same order.
#pragma once
#include <cassert>
#include <cstddef>
#include <cstring>
#include <type_traits>
#include <utility>
#include <vector>

namespace demolish {

class StateWriter {
  public:
    template <class T>
    void value(const T& v) {
        append(&v, sizeof(T));
    }
    template <class T>
    void values(const std::vector<T>& v) {
        append(v.data(), v.size() * sizeof(T));
    }
    std::vector<std::byte> bytes() { return std::move(bytes_); }

  private:
    void append(const void* data, size_t size) {
        const auto* first = static_cast<const std::byte*>(data);
        bytes_.insert(bytes_.end(), first, first + size);
    }
    std::vector<std::byte> bytes_;
};

/// Reads what a StateWriter wrote; sizes are the reader's to know. Keeps a reference.
class StateReader {
  public:
    explicit StateReader(const std::vector<std::byte>& bytes) : bytes_(bytes) {}
    template <class T>
    void value(T& v) {
        take(&v, sizeof(T));
    }
    template <class T>
    void values(std::vector<T>& v) {
        take(v.data(), v.size() * sizeof(T));
    }

  private:
    void take(void* data, size_t size) {
        assert(at_ + size <= bytes_.size());
        if (size > 0) std::memcpy(data, bytes_.data() + at_, size);
        at_ += size;
    }
    const std::vector<std::byte>& bytes_;
    size_t at_ = 0;
};

}  // namespace demolish
