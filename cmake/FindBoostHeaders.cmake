# SPDX-License-Identifier: Apache-2.0
# Finds the headers of Boost.Multiprecision, with or without Boost's own CMake package (a distribution may have split
# that off, and a copied Boost has none). Defines BoostHeaders_FOUND and, where it is missing, the target Boost::headers.
if(NOT TARGET Boost::headers)
    find_package(Boost 1.74 CONFIG QUIET)
endif()
if(TARGET Boost::headers)
    get_target_property(BoostHeaders_INCLUDE_DIR Boost::headers INTERFACE_INCLUDE_DIRECTORIES)
else()
    find_path(BoostHeaders_INCLUDE_DIR boost/multiprecision/cpp_int.hpp)
    mark_as_advanced(BoostHeaders_INCLUDE_DIR)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(BoostHeaders
    REQUIRED_VARS BoostHeaders_INCLUDE_DIR
    REASON_FAILURE_MESSAGE
        "install libboost-dev (Debian, Ubuntu), boost (Homebrew, Conan) or boost-multiprecision (vcpkg)")

if(BoostHeaders_FOUND AND NOT TARGET Boost::headers)
    add_library(Boost::headers INTERFACE IMPORTED)
    set_target_properties(Boost::headers PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${BoostHeaders_INCLUDE_DIR}")
endif()
