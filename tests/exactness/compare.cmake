# Runs COMMAND and compares what it prints with the file TABLE; keeps what it printed in ACTUAL.
execute_process(COMMAND ${COMMAND} OUTPUT_FILE ${ACTUAL} COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} -E compare_files ${TABLE} ${ACTUAL} RESULT_VARIABLE different)
if(different)
    message(FATAL_ERROR "the digests differ: diff ${TABLE} ${ACTUAL}")
endif()
