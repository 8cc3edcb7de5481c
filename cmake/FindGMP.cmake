# SPDX-License-Identifier: Apache-2.0
# Finds GMP and its C++ interface. Defines GMP_FOUND, GMP_VERSION and the imported targets GMP::gmp and GMP::gmpxx.
# Installed beside the package config of cleave, because CMake ships no such module.
find_path(GMP_INCLUDE_DIR gmp.h)
find_path(GMPXX_INCLUDE_DIR gmpxx.h)
find_library(GMP_LIBRARY gmp)
find_library(GMPXX_LIBRARY gmpxx)
mark_as_advanced(GMP_INCLUDE_DIR GMPXX_INCLUDE_DIR GMP_LIBRARY GMPXX_LIBRARY)

if(GMP_INCLUDE_DIR)
    file(STRINGS "${GMP_INCLUDE_DIR}/gmp.h" GMP_VERSION REGEX "^#define __GNU_MP_(VERSION|VERSION_MINOR|VERSION_PATCHLEVEL) ")
    string(REGEX REPLACE "[^0-9;]" "" GMP_VERSION "${GMP_VERSION}")
    string(REPLACE ";" "." GMP_VERSION "${GMP_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(GMP
    REQUIRED_VARS GMPXX_LIBRARY GMP_LIBRARY GMPXX_INCLUDE_DIR GMP_INCLUDE_DIR
    VERSION_VAR GMP_VERSION
    REASON_FAILURE_MESSAGE "install libgmp-dev (Debian, Ubuntu), gmp (Homebrew, Conan) or gmp[cxx] (vcpkg)")

if(GMP_FOUND AND NOT TARGET GMP::gmp)
    add_library(GMP::gmp UNKNOWN IMPORTED)
    set_target_properties(GMP::gmp PROPERTIES
        IMPORTED_LOCATION "${GMP_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${GMP_INCLUDE_DIR}")
endif()
if(GMP_FOUND AND NOT TARGET GMP::gmpxx)
    add_library(GMP::gmpxx UNKNOWN IMPORTED)
    set_target_properties(GMP::gmpxx PROPERTIES
        IMPORTED_LOCATION "${GMPXX_LIBRARY}"
        INTERFACE_INCLUDE_DIRECTORIES "${GMPXX_INCLUDE_DIR}"
        INTERFACE_LINK_LIBRARIES GMP::gmp)
endif()
