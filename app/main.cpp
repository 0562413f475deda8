// SPDX-License-Identifier: Apache-2.0
// The program's front: subcommands, errors to exit codes.
#include "app/commands/program.h"

int main(int argument_count, char** arguments) {
    return demolish::runProgram(argument_count, arguments);
}
