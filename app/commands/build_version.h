// SPDX-License-Identifier: Apache-2.0
// Which state of the program this is.
#pragma once

namespace demolish {

/// "0.1.0 (1a2b3c4d5e6f)": version, and the commit that was built, "-dirty" behind it where files had
/// changed, "unknown" outside of a git tree. cmake/Version.cmake writes it at build time.
const char* buildVersion();

}  // namespace demolish
