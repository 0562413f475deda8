// SPDX-License-Identifier: Apache-2.0
// Bytes of snapshots: what is written is read back, and what is cut off is refused.
#include "sim_cuda/solver/byte_stream.h"

#include <gtest/gtest.h>

namespace demolish::tests {
namespace {

std::vector<std::byte> written() {
    ByteStream out;
    out.writeValue(3.5);
    out.writeVector(std::vector<uint32_t>{1, 2, 3});
    out.writeVector(std::vector<uint32_t>{});
    return out.take();
}

TEST(ByteStream, WhatIsWrittenIsReadBackInOrder) {
    ByteStream in(written());
    EXPECT_EQ(in.readValue<double>(), 3.5);
    EXPECT_EQ(in.readVector<uint32_t>(), (std::vector<uint32_t>{1, 2, 3}));
    EXPECT_FALSE(in.atEnd());
    EXPECT_TRUE(in.readVector<uint32_t>().empty());
    EXPECT_TRUE(in.atEnd());
    EXPECT_THROW(in.readValue<char>(), std::out_of_range);
}

TEST(ByteStream, BytesThatAreCutOffAreRefusedWhereverTheyEnd) {
    const std::vector<std::byte> whole = written();
    for (size_t length = 0; length < whole.size(); ++length) {
        ByteStream in({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
        EXPECT_THROW(
            {
                in.readValue<double>();
                in.readVector<uint32_t>();
                in.readVector<uint32_t>();
            },
            std::out_of_range)
            << length;
    }
}

TEST(ByteStream, ACountBeyondTheBytesIsRefusedBeforeMemoryIsTaken) {
    ByteStream out;
    out.writeValue(~uint64_t{0});
    ByteStream in(out.take());
    EXPECT_THROW(in.readVector<double>(), std::out_of_range);
}

}  // namespace
}  // namespace demolish::tests
