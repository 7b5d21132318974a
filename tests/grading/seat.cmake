# raysteps_seat(<stage> <precision> <reference of another stage>...)
#
# A seat is a worker that lacks one file, the student's. For the stage and precision (f32, f64):
#
# seats/<stage>_<precision>.o    all of the worker but the stage's own file, as one object
# seats/<stage>_<precision>.txt  how that file is compiled and linked to it, an option a line
#
# <stage>_<precision>_seat is the target that makes both.
function(raysteps_seat stage precision)
    set(folder ${PROJECT_BINARY_DIR}/seats)
    set(object ${folder}/${stage}_${precision}.o)
    set(objects)
    foreach(part IN ITEMS
            raysteps_worker_${precision} raysteps_common_${precision} raysteps_neutral)
        list(APPEND objects $<TARGET_OBJECTS:${part}>)
    endforeach()
    set(libraries -static)
    set(own_libraries)
    if(stage STREQUAL "step13_meshes")  # whose OpenMesh is a shared library
        list(APPEND objects $<TARGET_OBJECTS:raysteps_mesh_file>)
        set(libraries)
        set(own_libraries "$<TARGET_LINKER_FILE:OpenMeshCore>")
    endif()
    foreach(other IN LISTS ARGN)
        list(APPEND objects $<TARGET_OBJECTS:${other}_${precision}>)
    endforeach()
    list(APPEND objects $<TARGET_PROPERTY:${stage}_picture_${precision},INTERFACE_SOURCES>)
    set(objects "$<FILTER:${objects},EXCLUDE,cmake_pch>")  # which CMake counts as one
    add_custom_command(OUTPUT ${object}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${CMAKE_CXX_COMPILER} -r -nostdlib -o ${object} "${objects}"
        DEPENDS "${objects}" COMMAND_EXPAND_LISTS VERBATIM)
    add_custom_target(${stage}_${precision}_seat DEPENDS ${object})

    set(few_errors -fmax-errors=20)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        set(few_errors -ferror-limit=20)
    endif()
    set(of_precision $<$<STREQUAL:${precision},f32>:-DRT_FLOAT>)
    set(fast_linker $<$<BOOL:${RAYSTEPS_MOLD}>:-fuse-ld=mold>)
    set(definitions $<TARGET_PROPERTY:raysteps_options,INTERFACE_COMPILE_DEFINITIONS>)
    get_target_property(headers glm::glm INTERFACE_INCLUDE_DIRECTORIES)
    list(REMOVE_ITEM headers ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
    list(TRANSFORM headers PREPEND "compile -isystem")
    set(lines
        "compiler ${CMAKE_CXX_COMPILER}"
        "compile -std=c++20" "compile -O2"
        "compile $<JOIN:$<TARGET_PROPERTY:raysteps_options,INTERFACE_COMPILE_OPTIONS>,\ncompile >"
        "compile ${few_errors}"
        "compile -w"  # they are told to who writes the file, not to who grades it
        "compile -D$<JOIN:${definitions},\ncompile -D>"
        ${headers}
        "compile ${of_precision}"
        "link ${libraries}"
        "link ${fast_linker}"
        "library ${own_libraries}"
        "library -lpng" "library -lz")
    list(JOIN lines "\n" text)
    file(GENERATE OUTPUT ${folder}/${stage}_${precision}.txt CONTENT "${text}\n")
endfunction()
