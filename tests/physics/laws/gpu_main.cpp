// SPDX-License-Identifier: Apache-2.0
// main() of the law tests on the GPU: 77 where there is none, so that CTest says Skipped.
#include <cuda_runtime.h>
#include <gtest/gtest.h>

#include <cstdio>

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    int devices = 0;
    const cudaError_t found = cudaGetDeviceCount(&devices);
    if (found != cudaSuccess || devices == 0) {
        std::printf("No GPU: %s\n", cudaGetErrorString(found));
        constexpr int kSkipped = 77;
        return kSkipped;
    }
    return RUN_ALL_TESTS();
}
