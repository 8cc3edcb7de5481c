# SPDX-License-Identifier: Apache-2.0
# Installs BUILD into an empty PREFIX. Only what needs no compiled program: the headers and the CMake package.
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}" --component development
    COMMAND_ERROR_IS_FATAL ANY)
foreach(file IN ITEMS include/cleave.hpp include/cleave/version.hpp share/cleave/cmake/cleave-config.cmake)
    if(NOT EXISTS "${PREFIX}/${file}")
        message(FATAL_ERROR "${file} was not installed")
    endif()
endforeach()
