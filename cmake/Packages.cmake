# SPDX-License-Identifier: Apache-2.0
# Everything comes from the system's packages; nothing is vendored or downloaded.
find_package(TBB REQUIRED)
if(DEMOLISH_SANITIZE MATCHES "thread" AND TBB_DIR MATCHES "^/usr/lib")
    message(FATAL_ERROR "ThreadSanitizer needs a oneTBB built under it: run tests/support/tbb_for_tsan.sh first.")
endif()
find_package(assimp REQUIRED)
find_package(spdlog REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
find_package(glfw3 REQUIRED)
find_package(glm REQUIRED)
find_package(PNG REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(OpenGL REQUIRED COMPONENTS EGL)
find_package(Threads REQUIRED)
find_program(GLAD_PROGRAM glad HINTS /usr/bin REQUIRED)

# Dear ImGui: Debian's static library brings the GLFW and OpenGL 3 backends and has no CMake file of its own.
find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(IMGUI_LIBRARY imgui REQUIRED)
find_library(STB_LIBRARY NAMES libstb.a stb REQUIRED)  # reads Radiance pictures and textures; Debian's static imgui leaves its font code to it
add_library(imgui INTERFACE)
target_include_directories(imgui SYSTEM INTERFACE ${IMGUI_INCLUDE_DIR} ${IMGUI_INCLUDE_DIR}/backends)
find_package(Freetype)
target_link_libraries(imgui INTERFACE ${IMGUI_LIBRARY} ${STB_LIBRARY}
    $<$<TARGET_EXISTS:Freetype::Freetype>:Freetype::Freetype> glfw
    OpenGL::OpenGL ${CMAKE_DL_LIBS})

# The GL and EGL loader, written at build time by the packaged generator (offline, byte-identical on every run).
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
file(STRINGS ${PROJECT_SOURCE_DIR}/cmake/gl_extensions.txt gl_extensions)
list(JOIN gl_extensions "," gl_extensions)
add_custom_command(
    OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/src/egl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/glad/egl.h
    COMMAND ${GLAD_PROGRAM} --out-path ${glad_dir} --reproducible --api gl:core=4.5,egl=1.5
            --extensions ${gl_extensions} c --loader
    DEPENDS ${PROJECT_SOURCE_DIR}/cmake/gl_extensions.txt
    COMMENT "Generating the GL and EGL loader")
enable_language(C)
add_library(glad STATIC ${glad_dir}/src/gl.c ${glad_dir}/src/egl.c)
target_include_directories(glad SYSTEM PUBLIC ${glad_dir}/include)
target_link_libraries(glad PUBLIC ${CMAKE_DL_LIBS})
