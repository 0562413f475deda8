# SPDX-License-Identifier: Apache-2.0
# `cmake --build build/release --target tidy`: clang-tidy 14 with .clang-tidy over all sources of ours but the tests.
# Takes minutes; TIDY=engine/passes narrows it to paths that match, in the environment.
find_program(RUN_CLANG_TIDY NAMES run-clang-tidy-14 run-clang-tidy)
if(RUN_CLANG_TIDY AND CMAKE_EXPORT_COMPILE_COMMANDS)
    add_custom_target(tidy
        COMMAND sh -c "exec ${RUN_CLANG_TIDY} -quiet -p ${PROJECT_BINARY_DIR} \"${PROJECT_SOURCE_DIR}/(app|assets|engine|sim_cuda)/.*\${TIDY}\""
        DEPENDS glad VERBATIM USES_TERMINAL)
endif()
