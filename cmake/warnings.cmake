# SPDX-License-Identifier: Apache-2.0
# cleave_dev: what tests, examples and benchmarks of this repository link. Never exported, never seen by a consumer.
add_library(cleave_dev INTERFACE)
if(TARGET cleave_cleave)
    target_link_libraries(cleave_dev INTERFACE cleave_cleave)
else()
    target_link_libraries(cleave_dev INTERFACE cleave_core)
endif()

option(CLEAVE_WARNINGS_AS_ERRORS "A warning stops the build of cleave's own tests and programs" ${PROJECT_IS_TOP_LEVEL})

if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(cleave_dev INTERFACE
        -Wall          # the warnings about constructions that are easy to avoid and often wrong
        -Wextra        # more of them: unused parameters, missing initialisers, comparisons of mixed sign
        -Wpedantic     # standard C++ only: what a second compiler would reject (128-bit integers say __extension__)
        -Wshadow       # a name that hides another reads as one thing and means the other
        -Wconversion)  # a narrowing that nobody wrote is how an exact value stops being exact
    if(CLEAVE_WARNINGS_AS_ERRORS)
        target_compile_options(cleave_dev INTERFACE -Werror)
    endif()
endif()

# cleave_own_target(<target>): the properties of every program built here. Standard C++ without GNU extensions, so that
# what compiles here compiles elsewhere.
function(cleave_own_target target)
    target_link_libraries(${target} PRIVATE cleave_dev)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
endfunction()
