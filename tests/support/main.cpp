// SPDX-License-Identifier: Apache-2.0
// main() of every test program: 77 when all its tests were skipped, so that CTest says Skipped, not Passed.
#include <gmock/gmock.h>

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    const int code = RUN_ALL_TESTS();
    const auto& tests = *testing::UnitTest::GetInstance();
    const bool all_skipped = tests.skipped_test_count() > 0 && tests.successful_test_count() == 0;
    constexpr int kSkipped = 77;
    return code == 0 && all_skipped ? kSkipped : code;
}
