// SPDX-License-Identifier: Apache-2.0
// The ledger of a shot from when its books were opened, mostly its start, to a later moment: where the energy
// went, and whether it adds up.
#pragma once
#include "sim_cuda/api/stats.h"

namespace demolish {

struct EnergyBalance {
    EnergyLedger start;  ///< J, when the books were opened: when the first ball had been fired and nothing
                         ///< had moved, or at `since`
    EnergyLedger now;    ///< J
    double since = 0;    ///< s, of the shot

    /// J that came in: motion at the start, shots fired since, height lost, strain let go.
    double broughtIn() const;
    /// What is found again (kinetic, elastic, potential, damping, friction, fracture) less what was there,
    /// over what came in, plus 1. 1.00 when the books close; a run that steps badly gains energy. 1 when
    /// no more came in than the books are known to.
    double closure() const;
};

}  // namespace demolish
