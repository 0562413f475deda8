# SPDX-License-Identifier: Apache-2.0
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()

option(DEMOLISH_CUDA "Build the CUDA solver when a toolkit is found" ON)
option(DEMOLISH_TESTS "Build the tests" ON)
set(DEMOLISH_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize= takes them (empty: none)")
set(DEMOLISH_CPU_ARCH "x86-64-v3" CACHE STRING "Host instruction set; v3 has the FMA that the solver's fmaf() needs")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
    set(CMAKE_CUDA_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# Flags of every target of ours. No contraction: the CPU must give the bits that the GPU gives (architecture, decision 3).
add_library(demolish_flags INTERFACE)
target_include_directories(demolish_flags INTERFACE ${PROJECT_SOURCE_DIR})
set(host_flags -ffp-contract=off)
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
    list(APPEND host_flags -march=${DEMOLISH_CPU_ARCH})
endif()
set(host_warnings -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual)
# Errors where their text is known. Later compilers warn of more (GCC 14 of a std::optional that is never read empty), which
# must not stop anybody's first build.
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND host_warnings -Werror)
endif()
target_compile_options(demolish_flags INTERFACE
    "$<$<COMPILE_LANGUAGE:CXX>:${host_flags};${host_warnings}>")
if(DEMOLISH_SANITIZE)
    # GCC 12 sees uninitialised values in the library's own <regex> once sanitizers are on.
    target_compile_options(demolish_flags INTERFACE
        "$<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${DEMOLISH_SANITIZE};-fno-sanitize-recover=all;-fno-omit-frame-pointer;-Wno-maybe-uninitialized>")
    target_link_options(demolish_flags INTERFACE -fsanitize=${DEMOLISH_SANITIZE})
endif()
