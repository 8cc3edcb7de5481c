# SPDX-License-Identifier: Apache-2.0
# SOURCE must compile as it is, and must be refused once CLEAVE_MUST_NOT_COMPILE is defined, with a message that
# matches the regular expression in its line `// refused: <expression>`. Otherwise a missing include would pass.
file(STRINGS "${SOURCE}" expected REGEX "^// refused: ")
string(REGEX REPLACE "^// refused: " "" expected "${expected}")
if(expected STREQUAL "")
    message(FATAL_ERROR "${SOURCE} has no line '// refused: <regular expression>'")
endif()

list(FILTER INCLUDES EXCLUDE REGEX "^$")
list(TRANSFORM INCLUDES PREPEND "-I")
set(command "${COMPILER}" -std=c++20 -fsyntax-only ${INCLUDES} "${SOURCE}")

execute_process(COMMAND ${command} RESULT_VARIABLE status ERROR_VARIABLE message)
if(NOT status EQUAL 0)
    message(FATAL_ERROR "${SOURCE} does not compile even without CLEAVE_MUST_NOT_COMPILE:\n${message}")
endif()
execute_process(COMMAND ${command} -DCLEAVE_MUST_NOT_COMPILE RESULT_VARIABLE status ERROR_VARIABLE message)
if(status EQUAL 0)
    message(FATAL_ERROR "${SOURCE} compiled with CLEAVE_MUST_NOT_COMPILE defined, and must not")
endif()
if(NOT message MATCHES "${expected}")
    message(FATAL_ERROR "${SOURCE} was refused, but not because of '${expected}':\n${message}")
endif()
