# Runs PROGRAM with ARGS, its output into the file OUTPUT if there is one, and compares its exit code
# with EXPECTED.
set(output)
if(OUTPUT)
  set(output OUTPUT_FILE ${OUTPUT})
endif()
execute_process(COMMAND ${PROGRAM} ${ARGS} ${output} RESULT_VARIABLE status)
if(NOT status EQUAL EXPECTED)
  message(FATAL_ERROR "exit code ${status}, expected ${EXPECTED}")
endif()
