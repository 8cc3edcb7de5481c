# SPDX-License-Identifier: Apache-2.0
# Configures PROJECT from nothing; then builds and runs it, or (REFUSED) expects the configuration to fail as it says.
file(REMOVE_RECURSE "${BUILD}")
execute_process(
    COMMAND "${CMAKE_COMMAND}" -S "${PROJECT}" -B "${BUILD}" -G "${GENERATOR}"
        "-DCMAKE_CXX_COMPILER=${COMPILER}" -DCMAKE_BUILD_TYPE=Debug ${SETTINGS}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)

if(NOT REFUSED STREQUAL "")
    if(status EQUAL 0)
        message(FATAL_ERROR "the project was configured, and should have been refused:\n${output}")
    endif()
    if(NOT output MATCHES "${REFUSED}")
        message(FATAL_ERROR "the project was refused, but not because of '${REFUSED}':\n${output}")
    endif()
    return()
endif()

if(NOT status EQUAL 0)
    message(FATAL_ERROR "${output}")
endif()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${BUILD}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND "${BUILD}/consumer" COMMAND_ERROR_IS_FATAL ANY)
