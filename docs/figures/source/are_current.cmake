# cmake -D PROGRAM=… -D WRITTEN=… -D COMMITTED=… -P are_current.cmake
#
# Fails, and names the figures, unless PROGRAM writes exactly the *.svg files in COMMITTED. Its
# output stays in WRITTEN for inspection.

file(REMOVE_RECURSE ${WRITTEN})
execute_process(COMMAND ${PROGRAM} ${WRITTEN} COMMAND_ERROR_IS_FATAL ANY)

file(GLOB written RELATIVE ${WRITTEN} ${WRITTEN}/*.svg)
file(GLOB committed RELATIVE ${COMMITTED} ${COMMITTED}/*.svg)
set(figures ${written} ${committed})
list(REMOVE_DUPLICATES figures)
set(stale "")
foreach(figure IN LISTS figures)
    execute_process(
        COMMAND ${CMAKE_COMMAND} -E compare_files --ignore-eol
            ${WRITTEN}/${figure} ${COMMITTED}/${figure}
        RESULT_VARIABLE differs OUTPUT_QUIET ERROR_QUIET)
    if(differs)
        string(APPEND stale "\n  ${figure}")
    endif()
endforeach()
if(stale)
    message(FATAL_ERROR "Not what docs/figures draws now:${stale}\n"
        "Look at them in ${WRITTEN}; if they are right, build the target update_figures.")
endif()
