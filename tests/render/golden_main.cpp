// SPDX-License-Identifier: Apache-2.0
// The golden test takes one flag of its own.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/render/golden_test.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--update-goldens") == 0) demolish::engine::test::update_goldens = true;
    }
    return RUN_ALL_TESTS();
}
