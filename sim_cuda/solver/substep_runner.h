// SPDX-License-Identifier: Apache-2.0
// Runs substeps: how depends on the backend, see cpu_substep_runner.h and cuda_substep_runner.cuh.
#pragma once
#include "sim_cuda/solver/solver_data.h"

namespace demolish {

/// run(backend, data, contacts, params, ledger, n, follows): n substeps from data.current on, which turns
/// with each of them; `follows`: since the step before nothing that steps read has been written but the
/// state. runOne: one; runOn: n more right after it.
template <class Backend, class Real>
class SubstepRunner;

}  // namespace demolish
