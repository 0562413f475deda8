// SPDX-License-Identifier: Apache-2.0
// Items by several processes of this host, one to a GPU.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace demolish {

/// The device that job `slot` sees as its only one: the slot-th of CUDA_VISIBLE_DEVICES, or the slot's own
/// number when that is not set. Throws UsageError when the variable names fewer.
std::string visibleDevice(size_t slot, const char* cuda_visible_devices);

/// A GPU to each of so many jobs. Throws UsageError when there are fewer.
void checkGpus(size_t jobs, size_t gpus);

/// Starts this program once for each list of arguments, at most `jobs` at a time, each with a GPU of its own
/// (CUDA_VISIBLE_DEVICES) when `on_gpu`, and waits for all. After a failure no more are started, and the exit
/// code of the first one that failed is thrown as an Error; what it said stands on stderr. `done` hears how
/// many have ended well, one call at a time, on threads of the jobs.
void runJobs(const std::vector<std::vector<std::string>>& arguments, size_t jobs, bool on_gpu,
             const std::function<void(size_t done)>& done);

}  // namespace demolish
