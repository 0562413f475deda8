// SPDX-License-Identifier: Apache-2.0
// Megabytes that several threads copy: all of them, whatever is left over at the end.
#include "app/session/recorded_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace demolish {
namespace {

TEST(RecordedArray, HoldsEveryValueWhateverTheirNumber) {
    for (const size_t count : {size_t{0}, size_t{1}, size_t{87'381}, size_t{87'382}, size_t{3'500'001}}) {
        struct Triple {
            uint32_t a, b, c;
            bool operator==(const Triple&) const = default;
        };
        std::vector<Triple> values(count);
        for (uint32_t i = 0; i < count; ++i) values[i] = {i, ~i, 7 * i + 3};
        const RecordedArray kept{std::span<const Triple>(values)};
        std::vector<Triple> before = values;
        std::fill(values.begin(), values.end(), Triple{});
        EXPECT_TRUE(std::equal(before.begin(), before.end(), kept.span().begin(), kept.span().end()))
            << count;
    }
    EXPECT_TRUE(RecordedArray<int>().span().empty());
}

}  // namespace
}  // namespace demolish
