# SPDX-License-Identifier: Apache-2.0
# cmake -DSOURCE=... -DVERSION=... -DOUTPUT=... -P Version.cmake: writes the one source that knows the commit, and only when
# that has changed.
set(COMMIT unknown)
find_program(git_program git)
if(git_program)
    execute_process(COMMAND ${git_program} -C ${SOURCE} rev-parse --show-toplevel OUTPUT_VARIABLE tree
        OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    file(REAL_PATH ${SOURCE} source)
    if(tree STREQUAL source)  # not that of a tree round a copy of the sources
        execute_process(COMMAND ${git_program} -C ${SOURCE} describe --always --dirty --abbrev=12
            OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[// Written by cmake/Version.cmake.
#include "app/commands/build_version.h"

const char* demolish::buildVersion() {
    return "@VERSION@ (@COMMIT@)";
}
]])
