# Runs PROGRAM with ARGS and compares its exit code with EXPECTED.
execute_process(COMMAND ${PROGRAM} ${ARGS} RESULT_VARIABLE status)
if(NOT status EQUAL EXPECTED)
  message(FATAL_ERROR "exit code ${status}, expected ${EXPECTED}")
endif()
