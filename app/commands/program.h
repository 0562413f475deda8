// SPDX-License-Identifier: Apache-2.0
// The program behind main(): subcommands, and the way from an error to a sentence and an exit code.
#pragma once

namespace demolish {

/// Exit codes: 0 done, 2 usage, 3 input file, 4 device or GL, 5 numerical failure, 6 output.
int runProgram(int argument_count, char** arguments);

}  // namespace demolish
