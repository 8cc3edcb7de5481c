# SPDX-License-Identifier: Apache-2.0
# Looks for what cleave can use, and says what is missing and how to get it. Nothing is ever downloaded here.

# cleave_explain_missing(<level> <what> <what for> DEBIAN <package> [VCPKG <port>] [CONAN <recipe>] [BREW <formula>])
# prints one message that names the package in each package manager. <level> is a message() mode.
function(cleave_explain_missing level what purpose)
    cmake_parse_arguments(PARSE_ARGV 3 arg "" "DEBIAN;VCPKG;CONAN;BREW" "")
    set(text "cleave: ${what} was not found; it is needed for ${purpose}. Get it with one of\n")
    string(APPEND text "    apt-get install ${arg_DEBIAN}      (Debian 12, Ubuntu 24.04 and newer)\n")
    if(arg_VCPKG)
        string(APPEND text "    vcpkg install ${arg_VCPKG}\n")
    endif()
    if(arg_CONAN)
        string(APPEND text "    conan install --requires ${arg_CONAN}\n")
    endif()
    if(arg_BREW)
        string(APPEND text "    brew install ${arg_BREW}\n")
    endif()
    string(APPEND text "or add the folder where it is installed to CMAKE_PREFIX_PATH.")
    message(${level} "${text}")
endfunction()

# This scope only: a project that adds cleave by add_subdirectory keeps its own module path.
set(cleave_saved_module_path "${CMAKE_MODULE_PATH}")
list(PREPEND CMAKE_MODULE_PATH "${CMAKE_CURRENT_LIST_DIR}")
find_package(Threads REQUIRED)
find_package(GMP QUIET)
find_package(BoostHeaders QUIET)
find_package(TBB CONFIG QUIET)
set(CMAKE_MODULE_PATH "${cleave_saved_module_path}")
unset(cleave_saved_module_path)

if(NOT GMP_FOUND)
    cleave_explain_missing(STATUS "GMP with its C++ interface (gmpxx.h)" "cleave::gmp and its fast rationals"
        DEBIAN libgmp-dev VCPKG "gmp[cxx]" CONAN "gmp/6.3.0 -o gmp/*:enable_cxx=True" BREW gmp)
endif()
if(NOT BoostHeaders_FOUND)
    cleave_explain_missing(STATUS "Boost.Multiprecision (boost/multiprecision/cpp_int.hpp, 1.74 or newer)"
        "cleave::boost, and for rationals where GMP is missing"
        DEBIAN libboost-dev VCPKG boost-multiprecision CONAN "boost/1.83.0" BREW boost)
endif()
if(NOT GMP_FOUND AND NOT BoostHeaders_FOUND)
    message(WARNING "cleave: neither GMP nor Boost.Multiprecision was found, so there are no rationals: "
        "only cleave::core is defined. See the messages above for how to get them.")
endif()
