# SPDX-License-Identifier: Apache-2.0
# The targets a consumer links.
#
#   cleave::core    the headers, no third party (numbers: the library's own)
#   cleave::gmp     core with GMP's mpz_class and mpq_class
#   cleave::boost   core with Boost.Multiprecision
#   cleave::tbb     core with oneTBB as an executor
#   cleave::cleave  core + gmp + boost, as found: what most projects want
#
# A consumer gets the include folder (as a system folder, so that its own warnings stay its own), C++20, and nothing
# else: no warning flags, no optimisation flags.

# Warnings must reach the headers while cleave itself is developed.
if(PROJECT_IS_TOP_LEVEL)
    set(cleave_system "")
else()
    set(cleave_system SYSTEM)
endif()

add_library(cleave_core INTERFACE)
add_library(cleave::core ALIAS cleave_core)
target_compile_features(cleave_core INTERFACE cxx_std_20)
target_include_directories(cleave_core ${cleave_system} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>)
target_link_libraries(cleave_core INTERFACE Threads::Threads)

# The parts linked decide which numbers the headers use, not what happens to lie in a system folder
# (see base/config.hpp).
target_compile_definitions(cleave_core INTERFACE CLEAVE_PARTS_CHOSEN)

# cleave_add_part(<name> <library target>): the target cleave::<name> = core + that library.
function(cleave_add_part name library)
    add_library(cleave_${name} INTERFACE)
    add_library(cleave::${name} ALIAS cleave_${name})
    target_link_libraries(cleave_${name} INTERFACE cleave_core ${library})
    set_target_properties(cleave_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

set_target_properties(cleave_core PROPERTIES EXPORT_NAME core)
cleave_add_part(gmp GMP::gmpxx)
cleave_add_part(boost Boost::headers)
cleave_add_part(tbb TBB::tbb)
target_compile_definitions(cleave_gmp INTERFACE CLEAVE_WITH_GMP)
target_compile_definitions(cleave_boost INTERFACE CLEAVE_WITH_BOOST)

set(cleave_default_parts "")
if(GMP_FOUND)
    list(APPEND cleave_default_parts gmp)
endif()
if(BoostHeaders_FOUND)
    list(APPEND cleave_default_parts boost)
endif()
if(cleave_default_parts)
    add_library(cleave_cleave INTERFACE)
    add_library(cleave::cleave ALIAS cleave_cleave)
    set_target_properties(cleave_cleave PROPERTIES EXPORT_NAME cleave)
    foreach(part IN LISTS cleave_default_parts)
        target_link_libraries(cleave_cleave INTERFACE cleave_${part})
    endforeach()
endif()
