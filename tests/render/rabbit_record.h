// SPDX-License-Identifier: Apache-2.0
// Makes the stored states anew (--record-states): a ball hits the rabbit, lightly and hard.
#pragma once

namespace demolish::engine::test {

/// Simulates on the CPU, writes tests/render/data, says what came out.
void recordStates();

}  // namespace demolish::engine::test
