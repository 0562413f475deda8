# SPDX-License-Identifier: Apache-2.0
# `cmake --install build/release --prefix DIR` makes a bundle that runs from any folder: bin/demolish, lib/ with the shared
# libraries beyond glibc and the GL/CUDA driver, share/demolish with shaders and assets. `--component tests` adds the tests.
set(data_dir share/demolish)
set(bundle_rpath "$ORIGIN/../lib")
set_target_properties(demolish_program PROPERTIES INSTALL_RPATH ${bundle_rpath})
install(TARGETS demolish_program RUNTIME DESTINATION bin COMPONENT program)
install(DIRECTORY shaders DESTINATION ${data_dir} COMPONENT program)
install(DIRECTORY assets/models assets/materials assets/scenes assets/experiments assets/strength DESTINATION ${data_dir}/assets COMPONENT program
    FILES_MATCHING PATTERN "*.toml" PATTERN "*.obj")
set(font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf)
if(EXISTS ${font})
    install(FILES ${font} DESTINATION ${data_dir}/fonts COMPONENT program)
endif()
install(FILES LICENSE DESTINATION ${data_dir} COMPONENT program)

# The README and all pages and pictures that it leads to, each at its place: links hold in the bundle as well.
file(GLOB_RECURSE pages RELATIVE ${PROJECT_SOURCE_DIR} CONFIGURE_DEPENDS app/*.md assets/*.md docs/*.md docs/*.jpg docs/*.png engine/*.md
    sim_cuda/*.md tests/*.md)
foreach(page README.md CONTRIBUTING.md CHANGELOG.md ${pages})
    get_filename_component(place ${page} DIRECTORY)
    install(FILES ${page} DESTINATION ${data_dir}/${place} COMPONENT program)
endforeach()

# Of CUDA the program holds the runtime, and Thrust and CUB, which are headers; the driver is the machine's.
set(linked "")
if(DEMOLISH_WITH_CUDA)
    find_path(thrust_headers thrust/version.h HINTS ${CUDAToolkit_INCLUDE_DIRS} PATH_SUFFIXES cccl NO_CACHE)
    set(linked ${CUDA_cudart_static_LIBRARY})
    if(thrust_headers)
        list(APPEND linked ${thrust_headers}/thrust ${thrust_headers}/cub)
    endif()
endif()
install(CODE "set(linked \"${linked}\")" COMPONENT program)
install(CODE "include(\"${PROJECT_SOURCE_DIR}/cmake/Notices.cmake\")" COMPONENT program)

# The machine keeps its own glibc, loader and GPU driver: these must not travel.
install(CODE [[
    set(program "${CMAKE_INSTALL_PREFIX}/bin/demolish")
    file(GET_RUNTIME_DEPENDENCIES EXECUTABLES "${program}" RESOLVED_DEPENDENCIES_VAR libraries
        UNRESOLVED_DEPENDENCIES_VAR unresolved
        PRE_EXCLUDE_REGEXES "ld-linux" "^libc\\.so" "^libm\\.so" "^libpthread" "^libdl\\.so" "^librt\\.so" "^libresolv"
            "^lib(GL|EGL|GLX|GLdispatch|OpenGL|GLESv2)\\.so" "^libcuda\\.so" "^libnvidia")
    foreach(library ${libraries})
        file(INSTALL "${library}" DESTINATION "${CMAKE_INSTALL_PREFIX}/lib" FOLLOW_SYMLINK_CHAIN)
    endforeach()
    if(unresolved)
        message(WARNING "Not found, so not in the bundle: ${unresolved}")
    endif()
    # Header-only and static libraries, the generator whose output is compiled in, and the font.
    writeNotices("${CMAKE_INSTALL_PREFIX}/share/demolish"
        "libimgui-dev;libstb-dev;libglm-dev;libcli11-dev;nlohmann-json3-dev;libtomlplusplus-dev;libspdlog-dev;python3-glad;fonts-dejavu-core"
        "${linked}" "${libraries}")
]] COMPONENT program)

get_property(test_targets GLOBAL PROPERTY DEMOLISH_TEST_TARGETS)
if(test_targets)
    set_target_properties(${test_targets} PROPERTIES INSTALL_RPATH ${bundle_rpath})
    install(TARGETS ${test_targets} RUNTIME DESTINATION tests COMPONENT tests EXCLUDE_FROM_ALL)
endif()

# RPATH, not RUNPATH: libraries of the bundle must find each other there too.
target_link_options(demolish_program PRIVATE -Wl,--disable-new-dtags)
foreach(target ${test_targets})
    target_link_options(${target} PRIVATE -Wl,--disable-new-dtags)
endforeach()
