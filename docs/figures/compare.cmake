# Draws the figures and compares them with the committed ones.
execute_process(COMMAND ${FIGURES} . COMMAND_ERROR_IS_FATAL ANY)
file(GLOB drawn *.svg)
foreach(figure IN LISTS drawn)
    get_filename_component(name ${figure} NAME)
    execute_process(
        COMMAND ${CMAKE_COMMAND} -E compare_files ${figure} ${COMMITTED}/${name}
        RESULT_VARIABLE different)
    if(different)
        message(SEND_ERROR "${name} is not what the program draws: build update_figures")
    endif()
endforeach()
