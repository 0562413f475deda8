// SPDX-License-Identifier: Apache-2.0
// Sums over the ledger.
#include "app/session/energy_balance.h"

#include <algorithm>
#include <cmath>

namespace demolish {
namespace {

double booked(const EnergyLedger& e) {
    return e.kinetic + e.elastic + e.potential + e.damping + e.friction + e.fracture - e.external;
}

/// Sums of so many terms in single precision are known to this share of them.
constexpr double kRoundOff = 1e-6;

double magnitude(const EnergyLedger& e) {
    return std::abs(e.kinetic) + std::abs(e.elastic) + std::abs(e.potential) + std::abs(e.external);
}

}  // namespace

double EnergyBalance::broughtIn() const {
    return start.kinetic + (now.external - start.external) + std::max(0.0, start.potential - now.potential) +
           std::max(0.0, start.elastic - now.elastic);
}

double EnergyBalance::closure() const {
    const double in = broughtIn();
    return in > kRoundOff * magnitude(start) ? 1 + (booked(now) - booked(start)) / in : 1;
}

}  // namespace demolish
