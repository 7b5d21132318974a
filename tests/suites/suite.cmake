# For what tests compile once and run briefly: three quarters of the time of -O2.
set(quickly $<$<CONFIG:Release>:-O1>)

# raysteps_add_test(<name> <label> <properties> <command>...): its words contain no semicolon.
function(raysteps_add_test name label properties)
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS "${label}" ${properties})
endfunction()

# raysteps_suite_objects(<name> <precision> <source>... [<option of raysteps_target>...]): objects of test
# cases, which start from the kit's precompiled header.
function(raysteps_suite_objects name precision)
    raysteps_target(${name} OBJECT SOURCES ${ARGN} OPTIONS ${quickly}
        LIBRARIES raysteps_kit_${precision}_options HEADERS raysteps_kit_${precision})
endfunction()

# raysteps_link_suite(<program> <objects> <part>... [<option of raysteps_target>...]): the program of
# these test cases, linked to these parts. Of 3.6 MB, 1.4 would be symbols.
function(raysteps_link_suite program objects)
    raysteps_target(${program} APART SOURCES $<TARGET_OBJECTS:${objects}> LIBRARIES raysteps_kit_main
        PARTS raysteps_kit raysteps_drawn ${ARGN})
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT RAYSTEPS_SANITIZE AND NOT with_symbols)
        target_link_options(${program} PRIVATE $<$<CONFIG:Release>:-s>)
    endif()
endfunction()

# raysteps_suite(<name> [IN_DOUBLE | SANITIZED_IN_DOUBLE] [LABEL <label>]
#     [PICTURE <stage> | STAGES <name>...] SOURCES <source>...): the suite <name>_float and <name>_double:
# the sources, compiled as one, with that precision as Real, linked to STAGES: by default all references
# and the picture of the last stage that needs no meshes. It is built IN_DOUBLE only if it tests nothing
# with a Real in it, and SANITIZED_IN_DOUBLE only with sanitizers.
function(raysteps_suite name)
    cmake_parse_arguments(PARSE_ARGV 1 suite "IN_DOUBLE;SANITIZED_IN_DOUBLE" "LABEL;PICTURE" "STAGES;SOURCES")
    if(NOT suite_LABEL)
        set(suite_LABEL common)
    endif()
    if(NOT suite_PICTURE)
        set(suite_PICTURE ${last_without_meshes})
    endif()
    if(NOT suite_STAGES)
        set(suite_STAGES raysteps_common raysteps_references ${suite_PICTURE}_picture)
    endif()
    if(suite_SOURCES MATCHES "[;*]")
        set(whole WHOLE)
    else()
        set(whole APART)
    endif()
    foreach(precision IN ITEMS f32 f64)
        if(precision STREQUAL f32 AND (RAYSTEPS_SANITIZE AND suite_SANITIZED_IN_DOUBLE OR suite_IN_DOUBLE))
            continue()
        endif()
        set(program ${name}_test_${word_${precision}})
        raysteps_suite_objects(${program}_objects ${precision} ${suite_SOURCES} ${whole})
        raysteps_link_suite(${program} ${program}_objects ${suite_STAGES})
        raysteps_add_test(${name}_${word_${precision}} ${suite_LABEL} "" ${program})
    endforeach()
endfunction()

# raysteps_test_program(<name> <option of raysteps_target>...): a program of test cases that call no stage.
# raysteps_test(<name> <label> <option>...): the test <name>, which runs this program.
function(raysteps_test_program name)
    raysteps_target(${name}_test ${ARGN} OPTIONS ${quickly} HEADERS raysteps_kit_f64)
    target_link_libraries(${name}_test PRIVATE raysteps_kit_main raysteps_kit_f64_options)
endfunction()
function(raysteps_test name label)
    raysteps_test_program(${name} ${ARGN})
    raysteps_add_test(${name} "${label}" "" ${name}_test)
endfunction()

# raysteps_stage_suite(<stage>): the suite of a stage, with the student's own tests, and that of its
# `trace`, if there is one (<stage>_trace): the chosen file, with the references of the stages before
# it, so that a first check compiles no others. <suite>_context_f32 and _f64 are all that a program
# needs beside that file if it calls all stages. <stage>_suites_float and _double build both suites;
# `./course check` waits for the line that they print then.
function(raysteps_stage_suite stage)
    get_property(before GLOBAL PROPERTY RAYSTEPS_STAGES_OF_${stage})
    set(others ${stages})
    foreach(list IN ITEMS before others)
        list(REMOVE_ITEM ${list} ${stage})
        list(TRANSFORM ${list} APPEND _reference)
    endforeach()
    raysteps_collect(${stage}_context raysteps_common ${stage}_picture ${others})

    set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
    get_property(suite GLOBAL PROPERTY RAYSTEPS_SUITE_${stage})
    list(TRANSFORM suite PREPEND ${stage}/)
    if(NOT suite)
        set(suite ${stage})
    endif()
    list(TRANSFORM suite REPLACE "(.+)" "suites/\\1_test.cpp")
    file(GLOB own_tests ${step}/student/tests/*.cpp)
    set_source_files_properties(${own_tests} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    get_property(in_both GLOBAL PROPERTY RAYSTEPS_SANITIZED_IN_BOTH)
    if(NOT stage IN_LIST in_both)
        set(sanitized SANITIZED_IN_DOUBLE)
    endif()
    raysteps_suite(${stage} ${sanitized} LABEL ${stage} SOURCES ${suite} ${own_tests}
        STAGES ${stage} raysteps_common ${stage}_picture ${before})
    set(suites ${stage})
    set(trace suites/${stage}_trace_test.cpp)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${trace})
        raysteps_collect(${stage}_trace_context
            raysteps_common raysteps_references ${stage}_picture_without_main)
        raysteps_suite(${stage}_trace ${sanitized} LABEL ${stage} SOURCES ${trace}
            STAGES raysteps_common ${before} ${stage}_reference ${stage}_chosen_picture)
        list(APPEND suites ${stage}_trace)
    endif()
    foreach(word IN ITEMS float double)
        set(both ${stage}_suites_${word})
        add_custom_target(${both} COMMAND true COMMENT ${both})
        foreach(suite IN LISTS suites)
            if(TARGET ${suite}_test_${word})
                raysteps_link_for(${suite}_test_${word} ${stage})
                add_dependencies(${both} ${suite}_test_${word})
            endif()
        endforeach()
    endforeach()
    if(TARGET course)
        raysteps_course_suites(${stage})
    endif()
    if(RAYSTEPS_MISTAKES)
        foreach(suite IN LISTS suites)
            raysteps_answers(${suite})
        endforeach()
        if(TARGET course)
            raysteps_recognition(${stage})
        endif()
    endif()
endfunction()

# raysteps_course_suites(<stage>): the stage's workers, <stage>_worker_float and _double, of the chosen
# file, and <stage>_reference_worker, in double, and its suites for `./course`: with options for
# debugging, with a worker, and on the starter.
function(raysteps_course_suites stage)
    raysteps_worker(${stage}_reference_worker "" ${stage}_reference ${stage}_context)
    raysteps_worker(${stage}_worker_double "" ${stage} ${stage}_context)
    raysteps_worker(${stage}_worker_float "" ${stage} ${stage}_context ON_DEMAND)
    foreach(suite IN LISTS suites)
        raysteps_variant(${suite} debug -O0 -g -finstrument-functions
            $<$<CXX_COMPILER_ID:GNU>:-finstrument-functions-exclude-file-list=/usr/,common/>)
        raysteps_variant(${suite} sanitized -O1 -g -fsanitize=address,undefined
            -fno-sanitize-recover=all -fno-omit-frame-pointer)
    endforeach()
    if(EXISTS ${PROJECT_SOURCE_DIR}/steps/handout.txt)
        return()  # which has no stubs, nor every starter
    endif()
    raysteps_asked_suite(${stage} ${stage}_worker_double ${stage}_context)
    raysteps_other_answers(${stage} starter ${step}/starter/*.cpp EXCEPT main)
    if(TARGET ${stage}_trace_test_double)
        raysteps_asked_suite(${stage}_trace ${stage}_reference_worker
            raysteps_common raysteps_references ${stage}_picture)
        raysteps_other_answers(${stage}_trace starter ${step}/starter/main.cpp)
    endif()
endfunction()

# raysteps_variant(<suite> <word> <option>...): <suite>_<word>_float and _double: the suite of a
# student's file, if there is one, which is compiled and linked with these options. `./course debug` and
# `check --sanitize` build them by name.
function(raysteps_variant suite word)
    set(with_symbols ON)
    set(parts raysteps_common ${before} ${stage}_picture)
    file(GLOB files ${step}/student/*.cpp)
    if(suite STREQUAL stage)
        list(FILTER files EXCLUDE REGEX "/main\\.cpp$")
    else()
        set(parts raysteps_common ${before} ${stage}_reference ${stage}_picture_without_main)
        list(FILTER files INCLUDE REGEX "/main\\.cpp$")
    endif()
    if(NOT files)
        return()
    endif()
    raysteps_compile_twice(${suite}_${word}_student ${files} ON_DEMAND
        OPTIONS ${students_errors} ${ARGN} DEFINITIONS ${students_assertions})
    raysteps_both(raysteps_link_suite ${suite}_${word}_@word ${suite}_test_@word_objects
        ${suite}_${word}_student ${parts} ON_DEMAND)
    if(word STREQUAL "debug")
        raysteps_both(target_sources ${suite}_${word}_@word PRIVATE
            ${CMAKE_CURRENT_SOURCE_DIR}/kit/failing_call.cpp)
    else()
        raysteps_both(target_link_options ${suite}_${word}_@word PRIVATE ${ARGN})
    endif()
endfunction()

# raysteps_other_answers(<suite> <word> <source>...): <suite>_<word>_test_float and _double: the suite,
# linked to these sources, <suite>_<word>_f32 and _f64, in place of the stage's file.
function(raysteps_other_answers suite word)
    if(word STREQUAL "starter")  # for `./course audit`
        set(on_demand ON_DEMAND)
    endif()
    raysteps_compile_twice(${suite}_${word} ${ARGN} ${on_demand}
        OPTIONS -O0 HEADERS raysteps_unoptimized_@)
    raysteps_both(raysteps_link_suite ${suite}_${word}_test_@word ${suite}_test_@word_objects
        ${suite}_${word} ${suite}_context ${on_demand})
endfunction()

# raysteps_known_mistakes(<variable> <folder> <suite[/name]>...): the sources of these mistakes of
# mistakes/<suite>.txt or right answers of alternatives/<suite>.cpp; without a name, of all of them, of
# which RAYSTEPS_ANSWER selects one.
function(raysteps_known_mistakes variable folder)
    list(TRANSFORM ARGN REPLACE "(.+)" "${folder}/\\1.cpp" OUTPUT_VARIABLE files)
    set(${variable} ${files} PARENT_SCOPE)
    foreach(mistake file IN ZIP_LISTS ARGN files)
        string(REPLACE "/" ";" words ${mistake})
        list(GET words 0 suite)
        string(REGEX REPLACE "_trace$" "" stage ${suite})
        set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
        file(GLOB right ${PROJECT_SOURCE_DIR}/tests/alternatives/${suite}.cpp
            ${step}/main.cpp ${step}/reference/*.cpp)
        get_filename_component(folder_of_file ${file} DIRECTORY)
        file(MAKE_DIRECTORY ${folder_of_file})
        add_custom_command(OUTPUT ${file}
            COMMAND known_mistakes ${PROJECT_SOURCE_DIR} ${words} > ${file}
            DEPENDS known_mistakes ${PROJECT_SOURCE_DIR}/tests/mistakes/${suite}.txt ${right} VERBATIM)
    endforeach()
endfunction()

# raysteps_answers(<suite>): the tests mistake_<suite>_<name>_double, and
# alternative_<suite>_<name>_float and _double: the suite, linked to all known mistakes and all other
# right answers. Float shows no more about mistakes than double: only the suite's first is tested in
# float, too, or with -DRAYSTEPS_MISTAKES=both all are.
function(raysteps_answers suite)
    raysteps_known_mistakes(source ${CMAKE_CURRENT_BINARY_DIR}/answers ${suite})
    raysteps_other_answers(${suite} answers ${source})
    raysteps_both(target_compile_options ${suite}_answers_@ PRIVATE -w)  # they are wrong on purpose

    set(catalogue ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${suite}.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${catalogue})
    file(STRINGS ${catalogue} lines REGEX "^(mistake|caught by:) " ENCODING UTF-8)
    # It fails by an assertion: a missing case, or a crash, does not count.
    set(fails TIMEOUT 300 PASS_REGULAR_EXPRESSION "test cases: +1 \\|( +0 passed \\|)? +1 failed")
    set(words float double)
    foreach(line IN LISTS lines)
        if(line MATCHES "^mistake ([a-z0-9_]+) ")
            set(name ${CMAKE_MATCH_1})
            continue()
        endif()
        string(REGEX REPLACE "^caught by: " "" case "${line}")
        string(REGEX REPLACE "([][,*\\\\~])" "\\\\\\1" case "${case}")  # for Catch2
        foreach(word IN LISTS words)
            raysteps_add_test(mistake_${suite}_${name}_${word} mistakes
                "ENVIRONMENT;RAYSTEPS_ANSWER=${name};${fails}" ${suite}_answers_test_${word} "${case}")
        endforeach()
        if(NOT RAYSTEPS_MISTAKES STREQUAL "both")
            set(words double)
        endif()
    endforeach()
    file(GLOB alternatives alternatives/${suite}.cpp)
    set(lines)
    if(alternatives)
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${alternatives})
        file(STRINGS ${alternatives} lines REGEX "^// right " ENCODING UTF-8)
    endif()
    list(TRANSFORM lines REPLACE "^// right ([a-z0-9_]+)[ :].*" "\\1")
    foreach(name IN LISTS lines)  # all of the suite must pass
        foreach(word IN ITEMS float double)
            raysteps_add_test(alternative_${suite}_${name}_${word} alternatives
                "ENVIRONMENT;RAYSTEPS_ANSWER=${name}" ${suite}_answers_test_${word})
        endforeach()
    endforeach()
endfunction()
