// SPDX-License-Identifier: Apache-2.0
// Flags of its own: --update-goldens, --record-states.
#include <gtest/gtest.h>

#include <cstring>

#include "tests/render/golden_test.h"
#include "tests/render/rabbit_record.h"

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--update-goldens") == 0) demolish::engine::test::update_goldens = true;
        if (std::strcmp(argv[i], "--record-states") == 0) demolish::engine::test::recordStates();
    }
    return RUN_ALL_TESTS();
}
