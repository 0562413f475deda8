# SPDX-License-Identifier: Apache-2.0
# demolish_test(NAME unit_hertz SOURCES a.cpp b.cpp LIBS demolish_physics LABELS cpu [TIMEOUT 120] [LAUNCHER xvfb-run -a])
# One GoogleTest program, one CTest entry. Labels say what a test needs: cpu, gl, gpu,
# window, slow; and threads: what it runs is parallel, for ThreadSanitizer.
if(DEMOLISH_TESTS)
    enable_testing()
    find_package(GTest REQUIRED)
    add_library(demolish_test_main STATIC ${PROJECT_SOURCE_DIR}/tests/support/main.cpp)
    target_link_libraries(demolish_test_main PUBLIC demolish_flags GTest::gmock GTest::gtest)
endif()

function(demolish_test)
    cmake_parse_arguments(T "" "NAME;TIMEOUT" "SOURCES;LIBS;LABELS;LAUNCHER" ${ARGN})
    demolish_test_program(NAME ${T_NAME} SOURCES ${T_SOURCES} LIBS ${T_LIBS} demolish_test_main)
    demolish_test_entry(NAME ${T_NAME} PROGRAM ${T_NAME} LABELS ${T_LABELS} LAUNCHER ${T_LAUNCHER} TIMEOUT ${T_TIMEOUT})
endfunction()

# A program of the tests, part of the bundle's tests, with a main() of its own.
function(demolish_test_program)
    cmake_parse_arguments(T "" "NAME" "SOURCES;LIBS" ${ARGN})
    add_executable(${T_NAME} ${T_SOURCES})
    target_link_libraries(${T_NAME} PRIVATE demolish_flags ${T_LIBS})
    target_compile_definitions(${T_NAME} PRIVATE DEMOLISH_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    set_property(GLOBAL APPEND PROPERTY DEMOLISH_TEST_TARGETS ${T_NAME})
endfunction()

# One CTest entry: a test program with arguments. TIMEOUT in s, 300 if there is none.
function(demolish_test_entry)
    cmake_parse_arguments(T "" "NAME;PROGRAM;TIMEOUT" "ARGUMENTS;LABELS;LAUNCHER" ${ARGN})
    add_test(NAME ${T_NAME} COMMAND ${T_LAUNCHER} $<TARGET_FILE:${T_PROGRAM}> ${T_ARGUMENTS}
        WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    if(NOT T_TIMEOUT)
        set(T_TIMEOUT 300)
    endif()
    if(DEMOLISH_SANITIZE)
        math(EXPR T_TIMEOUT "10 * ${T_TIMEOUT}")
    endif()
    set_tests_properties(${T_NAME} PROPERTIES LABELS "${T_LABELS}" TIMEOUT ${T_TIMEOUT} SKIP_RETURN_CODE 77)
endfunction()

# The same program once more with its solvers on the GPU (tests/physics/solver/solver_under_test.h).
function(demolish_test_on_gpu NAME)
    add_test(NAME ${NAME}_gpu COMMAND $<TARGET_FILE:${NAME}> WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
    set_tests_properties(${NAME}_gpu PROPERTIES LABELS gpu TIMEOUT 600 SKIP_RETURN_CODE 77
        ENVIRONMENT DEMOLISH_TEST_DEVICE=cuda)
endfunction()
