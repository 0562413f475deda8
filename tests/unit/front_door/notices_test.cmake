# SPDX-License-Identifier: Apache-2.0
# cmake -D NOTICES=cmake/Notices.cmake -D FOLDER=DIR -P notices_test.cmake: a library that is linked in has a row and its terms,
# whether a package has installed it or a toolkit of its own.
cmake_policy(VERSION 3.25)
include(${NOTICES})
file(REMOVE_RECURSE ${FOLDER})
set(toolkit ${FOLDER}/toolkit)
file(WRITE ${toolkit}/EULA.txt "terms of the toolkit")
file(WRITE ${toolkit}/targets/machine/lib/librun_static.a "")
file(WRITE ${FOLDER}/packaged/libpackaged.a "")

# Knows one file, as of a package whose terms this machine has.
file(GLOB known RELATIVE /usr/share/doc /usr/share/doc/*/copyright)
list(GET known 0 package)
get_filename_component(package ${package} DIRECTORY)
set(dpkg_query ${FOLDER}/dpkg-query)
file(WRITE ${dpkg_query} "#!/bin/sh\ncase $2 in */libpackaged.a) echo \"${package}:amd64: $2\" ;; *) exit 1 ;; esac\n")
file(CHMOD ${dpkg_query} PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)

writeNotices(${FOLDER}/bundle "" "${toolkit}/targets/machine/lib/librun_static.a;${FOLDER}/packaged/libpackaged.a" "")
file(READ ${FOLDER}/bundle/THIRD_PARTY.md text)
foreach(row "| librun_static.a | within the program |  | [licenses/librun_static.a.txt](licenses/librun_static.a.txt) |"
        "| libpackaged.a | within the program | ${package} | [licenses/${package}.txt](licenses/${package}.txt) |")
    string(FIND "${text}" "${row}" place)
    if(place EQUAL -1)
        message(FATAL_ERROR "There is no row\n${row}\nin\n${text}")
    endif()
endforeach()
file(READ ${FOLDER}/bundle/licenses/librun_static.a.txt terms)
if(NOT terms STREQUAL "terms of the toolkit" OR NOT EXISTS ${FOLDER}/bundle/licenses/${package}.txt)
    message(FATAL_ERROR "The terms were not copied")
endif()
