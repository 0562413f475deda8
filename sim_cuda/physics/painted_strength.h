// SPDX-License-Identifier: Apache-2.0
// Set-up: what a painted colour makes of a bond's strength (models E.3).
#pragma once

namespace demolish {

/// Times the strength that the bond has otherwise; `value`: of the channel, 0 to 1; `least`: where it is 0.
inline double paintedStrength(double value, double least) {
    return least + (1 - least) * value;
}

}  // namespace demolish
