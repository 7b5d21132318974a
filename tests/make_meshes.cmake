# The meshes in MESHES equal the output of the program MAKE_MESHES, byte for byte, and the program
# refuses unknown names. FOLDER is for its output.

file(GLOB meshes ${MESHES}/*.off ${MESHES}/*.obj ${MESHES}/*.ply ${MESHES}/*.stl)
foreach(mesh IN LISTS meshes)
    get_filename_component(name ${mesh} NAME_WE)
    get_filename_component(file ${mesh} NAME)
    execute_process(COMMAND ${MAKE_MESHES} ${name} ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
    file(SHA256 ${mesh} expected)
    file(SHA256 ${FOLDER}/${file} found)
    if(NOT found STREQUAL expected)
        message(SEND_ERROR "${mesh} is not what make_meshes makes of ${name}")
    endif()
endforeach()
list(LENGTH meshes count)
if(count LESS 6)
    message(SEND_ERROR "expected six meshes or more in ${MESHES}, found ${count}")
endif()

execute_process(COMMAND ${MAKE_MESHES} --list COMMAND_ERROR_IS_FATAL ANY OUTPUT_VARIABLE list)
if(NOT list MATCHES "sphere_1m +.*1,003,520 triangles")
    message(SEND_ERROR "make_meshes --list does not say what sphere_1m is: ${list}")
endif()
foreach(wrong IN ITEMS "" "unicorn;${FOLDER}/unicorn.off" "cube;${FOLDER}/cube.txt"
        "cube;${FOLDER}/no/such/folder/cube.off")
    execute_process(COMMAND ${MAKE_MESHES} ${wrong} RESULT_VARIABLE status
        OUTPUT_QUIET ERROR_VARIABLE message)
    if(NOT status EQUAL 2 OR NOT message MATCHES "error: ")
        message(SEND_ERROR "make_meshes ${wrong}: expected status 2 and an error, not "
            "${status} and ${message}")
    endif()
endforeach()
