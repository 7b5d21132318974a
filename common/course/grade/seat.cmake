# raysteps_seat(<stage>): the target <stage>_seat, which makes the link kit of a graded worker of the
# stage, for the student's own files, in double. <file> is <stage>, the file of its functions, or
# <stage>_trace, its main.cpp:
#
# seats/<stage>.o             everything but the stages' own files and main.cpp, as one object
# seats/references/<file>.o   the reference of each, for grading another
# seats/graded/<file>.o       all of these but the graded file; it can call only the functions of
#                             the headers in steps/may_include.txt
# seats/graded/<file>.txt     the functions of all contracts, and their status for that file
# seats/<stage>.txt           one per line: the options for compiling a file of the stage and for linking,
#                             and with g++ its precompiled headers, and options that make its exit status
#                             that of the program that it ran: 128 + a signal
function(raysteps_seat stage)
    set(folder ${PROJECT_BINARY_DIR}/seats)
    set(objects $<TARGET_PROPERTY:${stage}_picture_without_main_f64,INTERFACE_SOURCES>)
    set(main $<TARGET_OBJECTS:${stage}_main_f64>)
    # A worker gets its meshes with the queries, and reads no file.
    set(objects "$<FILTER:${objects},EXCLUDE,raysteps_meshes_f64|raysteps_without_meshes_f64>")
    list(APPEND objects $<TARGET_OBJECTS:raysteps_without_meshes_f64>)
    # Nor has it a command line, or settings to choose.
    set(not_in_workers "raysteps_(base|(common|with_shapes)_f64)\\.dir/.*(program|scene_file|tuning)")
    foreach(part IN ITEMS raysteps_worker_f64 raysteps_common_f64 raysteps_with_shapes_f64 raysteps_base)
        list(APPEND objects "$<FILTER:$<TARGET_OBJECTS:${part}>,EXCLUDE,${not_in_workers}>")
    endforeach()
    raysteps_one_object(${folder}/${stage}.o "${objects}")
    raysteps_one_object(${folder}/references/${stage}.o $<TARGET_OBJECTS:${stage}_reference_f64>)
    raysteps_one_object(${folder}/references/${stage}_trace.o ${main})
    raysteps_graded_seat(${stage} ${stage} $<TARGET_OBJECTS:${stage}_reference_f64> "${objects};${main}")
    set(made ${stage}.o references/${stage}.o references/${stage}_trace.o graded/${stage}.o)
    if(TARGET ${stage}_trace_asked_test_double)
        raysteps_graded_seat(${stage}_trace ${stage} ${main} "${objects}")
        list(APPEND made graded/${stage}_trace.o)
    endif()
    list(TRANSFORM made PREPEND ${folder}/)
    add_custom_target(${stage}_seat DEPENDS ${made})

    set(few_errors $<IF:$<STREQUAL:${CMAKE_CXX_COMPILER_ID},Clang>,-ferror-limit=20,-fmax-errors=20>)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        raysteps_headers_of(${stage} start)
        get_target_property(common raysteps_common_f64 BINARY_DIR)
        set(precompiled "header ${common}/CMakeFiles/${start}_f64.dir/cmake_pch.hxx.gch"
            "main_header ${common}/CMakeFiles/raysteps_common_f64.dir/cmake_pch.hxx.gch")
        add_dependencies(${stage}_seat ${start}_f64 raysteps_common_f64)
        set(driver "driver -pass-exit-codes" "driver -wrapper"
            "driver sh,-c,\"$0\" \"$@\" || exit $?")
    endif()
    # Warnings are for the author of the file, not for the grader.
    set(options
        "$<FILTER:$<TARGET_PROPERTY:raysteps_options,INTERFACE_COMPILE_OPTIONS>,EXCLUDE,^-W>")
    set(definitions $<TARGET_PROPERTY:raysteps_options,INTERFACE_COMPILE_DEFINITIONS>)
    get_target_property(headers glm::glm INTERFACE_INCLUDE_DIRECTORIES)
    list(REMOVE_ITEM headers ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
    list(TRANSFORM headers PREPEND "compile -isystem")
    list(TRANSFORM students_assertions PREPEND "function -D" OUTPUT_VARIABLE assertions)
    set(lines "compiler ${CMAKE_CXX_COMPILER}" ${driver} "compile -std=c++20" "compile -O2"
        "compile $<JOIN:${options},\ncompile >" "compile ${students_errors}" "compile ${few_errors}"
        "compile -D$<JOIN:${definitions},\ncompile -D>"
        ${assertions} ${headers} ${precompiled}
        "link -static" "link $<$<BOOL:${RAYSTEPS_MOLD}>:-fuse-ld=mold>" "library -lpng" "library -lz")
    list(JOIN lines "\n" text)
    file(GENERATE OUTPUT ${folder}/${stage}.txt CONTENT "${text}\n")
endfunction()

# raysteps_graded_seat(<file> <stage> <own> <objects>): seats/graded/<file>.o and .txt, from the seat's
# objects and all other files' references; <own> are the objects of the file's own reference. The file
# may call the functions of the headers in steps/may_include.txt. A main.cpp may call those of all stages
# and of the worker's part of common/ too, but not the loop over the pixels in common/render/render.cpp,
# and not the parts of its own stage that are not listed, such as lighting.hpp. A file of functions is not
# linked to what computes the same and nothing calls in its worker: the stages' stories, and before the
# stage of meshes the hierarchy that draws them. tests/grading/seats_test.sh looks for them.
function(raysteps_graded_seat file stage own objects)
    set(may_include ${PROJECT_SOURCE_DIR}/steps/may_include.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${may_include})
    get_property(linked GLOBAL PROPERTY RAYSTEPS_STAGES_OF_${stage})
    get_property(own_loop GLOBAL PROPERTY RAYSTEPS_OWN_LOOP)
    get_property(with_meshes GLOBAL PROPERTY RAYSTEPS_MESHES)
    set(absent ${stages})
    list(REMOVE_ITEM absent ${linked})
    list(REMOVE_ITEM linked ${file})
    foreach(list IN ITEMS linked absent)
        list(TRANSFORM ${list} REPLACE "(.+)" "$<TARGET_OBJECTS:\\1_reference_f64>")
    endforeach()
    set(others ${linked} ${absent})
    set(parts "${objects};${linked}")
    if(file STREQUAL stage)
        set(whose "all|${stage}")
        set(unused "unity_stories|/story\\.cpp|/pixel_log_parts\\.cpp")
        if(NOT stage IN_LIST with_meshes)
            string(APPEND unused "|/mesh_bvh\\.cpp")
        endif()
        list(APPEND absent "$<FILTER:${parts},INCLUDE,${unused}>")
        set(parts "$<FILTER:${parts},EXCLUDE,${unused}>")
    else()
        set(whose "all|trace:${stage}")
        set(called "/(step[^/]*_(reference|shared)_f64|raysteps_(base|(common|with_shapes)_f64))\\.dir/")
        set(callable "$<FILTER:${parts},INCLUDE,${called}>")
        set(callable "$<FILTER:${callable},EXCLUDE,/${stage}_shared_f64\\.dir/>")
    endif()
    file(STRINGS ${may_include} names REGEX "^(${whose}) ")
    list(TRANSFORM names REPLACE "^.*/(.*)\\.hpp$" "\\1")
    if(NOT file STREQUAL stage AND NOT stage IN_LIST own_loop)
        list(APPEND names queries)
    endif()
    list(JOIN names "|" names)
    list(APPEND callable "$<FILTER:${parts},INCLUDE,/(${names})\\.cpp>")
    foreach(list IN ITEMS parts absent callable)  # a precompiled header is for CMake a single object
        set(${list} "$<FILTER:${${list}},EXCLUDE,cmake_pch>")
    endforeach()
    set(exported $<TARGET_OBJECTS:raysteps_exported_queries_f64>)
    set(out ${PROJECT_BINARY_DIR}/seats/graded/${file})
    set(script ${PROJECT_SOURCE_DIR}/common/course/grade/graded_seat.sh)
    add_custom_command(OUTPUT ${out}.o BYPRODUCTS ${out}.txt
        COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/seats/graded
        COMMAND sh ${script} ${out}.o ${out}.txt ${CMAKE_CXX_COMPILER} ${CMAKE_NM} ${CMAKE_OBJCOPY}
            ${exported} "${parts}" -- ${own} -- "${callable}" -- "${absent}" -- ${others}
        DEPENDS ${script} ${exported} "${parts}" ${own} "${absent}" COMMAND_EXPAND_LISTS VERBATIM)
endfunction()

# raysteps_one_object(<file> <objects>)
function(raysteps_one_object file objects)
    set(objects "$<FILTER:${objects},EXCLUDE,cmake_pch>")  # for CMake a single object
    get_filename_component(folder ${file} DIRECTORY)
    add_custom_command(OUTPUT ${file}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${CMAKE_CXX_COMPILER} -r -nostdlib -o ${file} "${objects}"
        DEPENDS "${objects}" COMMAND_EXPAND_LISTS VERBATIM)
endfunction()
