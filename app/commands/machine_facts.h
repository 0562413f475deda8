// SPDX-License-Identifier: Apache-2.0
// Where a run ran: the machine's own words for itself.
#pragma once
#include <string>

namespace demolish {

/// "AMD EPYC 9654".
std::string machineName();
/// Threads that oneTBB may use.
unsigned threadsInUse();
/// "NVIDIA 580.159.04, CUDA 13.0", as far as each is there; "none" without an NVIDIA driver.
std::string gpuDriver();

}  // namespace demolish
