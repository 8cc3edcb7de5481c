# SPDX-License-Identifier: Apache-2.0
# Installs the headers and the CMake package. One export file per part, so that a project which asks for
# `find_package(cleave COMPONENTS core)` needs neither GMP nor Boost.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(cleave_config_dir "${CMAKE_INSTALL_DATADIR}/cleave/cmake")

install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT development
    FILES_MATCHING PATTERN "*.hpp")
install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/cleave" COMPONENT development)

set(cleave_parts core gmp boost tbb)
if(TARGET cleave_cleave)
    list(APPEND cleave_parts cleave)
endif()
foreach(part IN LISTS cleave_parts)
    install(TARGETS cleave_${part} EXPORT cleave-${part} INCLUDES DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
    install(EXPORT cleave-${part} NAMESPACE cleave:: FILE cleave-${part}.cmake DESTINATION "${cleave_config_dir}"
        COMPONENT development)
endforeach()

string(REPLACE ";" " " cleave_default_components "${cleave_default_parts}")
configure_package_config_file(cmake/cleave-config.cmake.in "${PROJECT_BINARY_DIR}/cleave-config.cmake"
    INSTALL_DESTINATION "${cleave_config_dir}" NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/cleave-config-version.cmake"
    COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
    "${PROJECT_BINARY_DIR}/cleave-config.cmake"
    "${PROJECT_BINARY_DIR}/cleave-config-version.cmake"
    cmake/FindGMP.cmake
    cmake/FindBoostHeaders.cmake
    DESTINATION "${cleave_config_dir}" COMPONENT development)
