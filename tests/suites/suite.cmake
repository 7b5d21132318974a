# For what tests compile once and run briefly: three quarters of the time of -O2.
set(quickly $<$<CONFIG:Release>:-O1>)

# raysteps_add_test(<name> <label> <properties> <command>...): its words contain no semicolon.
function(raysteps_add_test name label properties)
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS "${label}" ${properties})
endfunction()

# raysteps_suite_objects(<name> <precision> <source>...): an object library of test cases, which starts
# from the precompiled header of the kit, or of another library: ${suite_headers}_f32 or _f64.
function(raysteps_suite_objects name precision)
    add_library(${name} OBJECT ${ARGN})
    target_link_libraries(${name} PRIVATE raysteps_kit_${precision}_options)
    target_compile_options(${name} PRIVATE ${quickly})
    if(NOT suite_headers)
        set(suite_headers raysteps_kit)
    endif()
    target_precompile_headers(${name} REUSE_FROM ${suite_headers}_${precision})
endfunction()

function(raysteps_link_suite_with_symbols program objects precision)
    add_executable(${program} $<TARGET_OBJECTS:${objects}>)
    raysteps_link(${program} ${precision} raysteps_kit raysteps_drawn ${ARGN})
    target_link_libraries(${program} PRIVATE raysteps_kit_main)
endfunction()

# raysteps_link_suite(<program> <objects> <precision> <name>...): the program of these test cases,
# linked to <name>_f32 or _f64 of each name.
function(raysteps_link_suite program objects precision)
    raysteps_link_suite_with_symbols(${program} ${objects} ${precision} ${ARGN})
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT RAYSTEPS_SANITIZE)  # 1.4 of 3.6 MB are symbols
        target_link_options(${program} PRIVATE $<$<CONFIG:Release>:-s>)
    endif()
endfunction()

# raysteps_suite(<name> [SANITIZED_IN_DOUBLE] [LABEL <label>] [PICTURE <stage> | STAGES <name>...]
#     SOURCES <source>...): the suite <name>_float and <name>_double: the sources, with that precision
# as Real, in one program each, linked to STAGES: by default all references and the picture of the
# last stage that needs no meshes. SANITIZED_IN_DOUBLE: with sanitizers, it is built in double only.
# Several sources are compiled as one, in two thirds of the time, but for those with the property
# SKIP_UNITY_BUILD_INCLUSION.
function(raysteps_suite name)
    cmake_parse_arguments(PARSE_ARGV 1 suite "SANITIZED_IN_DOUBLE" "LABEL;PICTURE" "STAGES;SOURCES")
    if(NOT suite_LABEL)
        set(suite_LABEL common)
    endif()
    if(NOT suite_PICTURE)
        set(suite_PICTURE ${last_without_meshes})
    endif()
    if(NOT suite_STAGES)
        set(suite_STAGES raysteps_common raysteps_references ${suite_PICTURE}_picture)
    endif()
    list(LENGTH suite_SOURCES files)
    set(precisions f32 f64)
    if(suite_SANITIZED_IN_DOUBLE AND RAYSTEPS_SANITIZE)
        set(precisions f64)
    endif()
    foreach(precision IN LISTS precisions)
        set(program ${name}_test_${word_${precision}})
        raysteps_suite_objects(${program}_objects ${precision} ${suite_SOURCES})
        if(files GREATER 1 AND NOT DEFINED CMAKE_UNITY_BUILD)
            set_target_properties(${program}_objects PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
        endif()
        raysteps_link_suite(${program} ${program}_objects ${precision} ${suite_STAGES})
        raysteps_add_test(${name}_${word_${precision}} ${suite_LABEL} "" ${program})
    endforeach()
endfunction()

# raysteps_test_program(<name> SOURCES <source>... LIBRARIES <library>... [DEFINITIONS <definition>...]
#     [NEEDS <target>...]): a program of test cases that call no stage. NEEDS are built before it.
function(raysteps_test_program name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "" "SOURCES;LIBRARIES;DEFINITIONS;NEEDS")
    raysteps_target(${name}_test SOURCES ${test_SOURCES} DEFINITIONS ${test_DEFINITIONS}
        LIBRARIES ${test_LIBRARIES} raysteps_kit_main raysteps_kit_f64_options OPTIONS ${quickly})
    target_precompile_headers(${name}_test REUSE_FROM raysteps_kit_f64)
    if(test_NEEDS)
        add_dependencies(${name}_test ${test_NEEDS})
    endif()
endfunction()

# raysteps_test(<name> <label> SOURCES …): the test <name>, which runs this program.
function(raysteps_test name label)
    raysteps_test_program(${name} ${ARGN})
    raysteps_add_test(${name} "${label}" "" ${name}_test)
endfunction()

# raysteps_stage_suite(<stage>): the suite of a stage, and the student's own tests: the chosen file,
# with the references of the stages before it, so that a first check compiles no others.
# <stage>_context_f32 and _f64 are everything that a program needs beside that file if it calls all
# stages. <stage>_suites_float and _double build this suite and that of `trace`; `./course check`
# waits for the line that they print then.
function(raysteps_stage_suite stage)
    set(others ${stages})
    list(REMOVE_ITEM others ${stage})
    get_property(always GLOBAL PROPERTY RAYSTEPS_IN_EVERY_PROGRAM)
    set(before ${others})
    foreach(other IN LISTS others)
        if(other STRGREATER stage OR other IN_LIST always)
            list(REMOVE_ITEM before ${other})
        endif()
    endforeach()
    list(REMOVE_ITEM always ${stage})
    list(PREPEND before ${always})
    list(TRANSFORM before APPEND _reference)
    list(TRANSFORM others APPEND _reference)
    raysteps_collect(${stage}_context raysteps_common ${stage}_picture ${others})

    get_property(suite GLOBAL PROPERTY RAYSTEPS_SUITE_${stage})
    list(TRANSFORM suite PREPEND ${stage}/)
    if(NOT suite)
        set(suite ${stage})
    endif()
    list(TRANSFORM suite REPLACE "(.+)" "suites/\\1_test.cpp")
    file(GLOB own_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${stage}/student/tests/*.cpp)
    set_source_files_properties(${own_tests} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    get_property(in_both GLOBAL PROPERTY RAYSTEPS_SANITIZED_IN_BOTH)
    if(NOT stage IN_LIST in_both)
        set(sanitized SANITIZED_IN_DOUBLE)
    endif()
    raysteps_suite(${stage} ${sanitized} LABEL ${stage} SOURCES ${suite} ${own_tests}
        STAGES ${stage} raysteps_common ${stage}_picture ${before})
    if(TARGET course)
        file(GLOB starter CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${stage}/starter/*.cpp)
        list(FILTER starter EXCLUDE REGEX "/main\\.cpp$")
        raysteps_starter(${stage} ${starter})
        raysteps_workers(${stage})
        if(COMMAND raysteps_asked_suite)
            raysteps_asked_suite(${stage} ${stage}_worker_double ${stage}_context)
        endif()
    endif()
    raysteps_trace_suite(${stage})
    if(TARGET course)
        raysteps_variant(${stage} debug -O0 -g -finstrument-functions
            $<$<CXX_COMPILER_ID:GNU>:-finstrument-functions-exclude-file-list=/usr/,common/>)
        raysteps_variant(${stage} sanitized -O1 -g -fsanitize=address,undefined
            -fno-sanitize-recover=all -fno-omit-frame-pointer)
    endif()
    foreach(word IN ITEMS float double)
        set(both ${stage}_suites_${word})
        add_custom_target(${both} COMMAND ${CMAKE_COMMAND} -E true COMMENT ${both})
        foreach(program IN ITEMS ${stage}_test_${word} ${stage}_trace_test_${word})
            if(TARGET ${program})
                add_dependencies(${both} ${program})
            endif()
        endforeach()
    endforeach()
    if(RAYSTEPS_MISTAKES)
        raysteps_answers(${stage} ${stage})
        if(TARGET course)
            raysteps_recognition(${stage})
        endif()
    endif()
endfunction()

# raysteps_trace_suite(<stage>): <stage>_trace_test_float and _double, if there is such a suite: the
# chosen main.cpp, with the references of its stage and of those before it.
function(raysteps_trace_suite stage)
    set(suite suites/${stage}_trace_test.cpp)
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${suite})
        return()
    endif()
    raysteps_collect(${stage}_trace_context
        raysteps_common raysteps_references ${stage}_picture_without_main)
    raysteps_suite(${stage}_trace ${sanitized} LABEL ${stage} SOURCES ${suite}
        STAGES raysteps_common ${before} ${stage}_reference ${stage}_chosen_picture)
    if(TARGET course)
        raysteps_starter(${stage}_trace ${PROJECT_SOURCE_DIR}/steps/${stage}/starter/main.cpp)
        if(COMMAND raysteps_asked_suite)
            raysteps_asked_suite(${stage}_trace ${stage}_reference_worker
                raysteps_common raysteps_references ${stage}_picture)
        endif()
    endif()
    if(RAYSTEPS_MISTAKES)
        raysteps_answers(${stage}_trace ${stage}/main)
        if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage}/trace.txt)
            raysteps_add_test(recognition_${stage}_trace mistakes "" sh
                ${PROJECT_SOURCE_DIR}/tests/trace_mistakes.sh check ${PROJECT_BINARY_DIR}
                ${PROJECT_SOURCE_DIR} ${stage})
        endif()
    endif()
endfunction()

# raysteps_variant(<stage> <word> <option>...): <stage>_<word>_float and _double, and with a student's
# main.cpp <stage>_trace_<word>_float and _double: the suites of a student's files, which are compiled
# and linked with these options. `./course debug` and `check --sanitize` build them by name.
function(raysteps_variant stage word)
    file(GLOB student CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${stage}/student/*.cpp)
    foreach(suite IN ITEMS ${stage} ${stage}_trace)
        set(files ${student})
        set(others raysteps_common ${before})
        if(suite STREQUAL stage)
            list(FILTER files EXCLUDE REGEX "/main\\.cpp$")
            list(APPEND others ${stage}_picture)
        else()
            list(FILTER files INCLUDE REGEX "/main\\.cpp$")
            list(APPEND others ${stage}_reference ${stage}_picture_without_main)
        endif()
        if(NOT files OR NOT TARGET ${suite}_test_double)
            continue()
        endif()
        set(own ${suite}_${word}_student)
        raysteps_compile_twice(${own} ${files})
        foreach(precision IN ITEMS f32 f64)
            set(program ${suite}_${word}_${word_${precision}})
            raysteps_link_suite_with_symbols(${program} ${suite}_test_${word_${precision}}_objects
                ${precision} ${own} ${others})
            target_compile_options(${own}_${precision} PRIVATE ${students_errors} ${ARGN})
            target_compile_definitions(${own}_${precision} PRIVATE ${students_assertions})
            if(word STREQUAL "debug")
                target_sources(${program} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/kit/failing_call.cpp)
            else()
                target_link_options(${program} PRIVATE ${ARGN})
            endif()
            set_target_properties(${program} ${own}_${precision} PROPERTIES EXCLUDE_FROM_ALL ON)
        endforeach()
    endforeach()
endfunction()

# raysteps_starter(<suite> <source>...): <suite>_starter_test_float and _double: the suite, linked to
# the stage's starter, for `./course audit`, which a hand-out has not; nor has it every starter.
function(raysteps_starter suite)
    if(EXISTS ${PROJECT_SOURCE_DIR}/steps/handout.txt)
        return()
    endif()
    raysteps_compile_twice(${suite}_starter ${ARGN})
    raysteps_both(raysteps_compile_without_optimizing ${suite}_starter_@ @)
    raysteps_both(raysteps_link_suite ${suite}_starter_test_@word ${suite}_test_@word_objects
        @ ${suite}_starter ${suite}_context)
    raysteps_both(set_target_properties ${suite}_starter_@ ${suite}_starter_test_@word
        PROPERTIES EXCLUDE_FROM_ALL ON)
endfunction()

# raysteps_known_mistake(<file> <suite> [<name>]): the source of one mistake of mistakes/<suite>.txt, or
# of all of them and of the other right answers, of which RAYSTEPS_ANSWER selects one.
function(raysteps_known_mistake file suite)
    string(REGEX REPLACE "_trace$" "" stage ${suite})
    set(alternatives ${PROJECT_SOURCE_DIR}/tests/alternatives/${stage})
    set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
    file(GLOB right CONFIGURE_DEPENDS
        ${alternatives}/*.cpp ${alternatives}/main/*.cpp ${step}/main.cpp ${step}/reference/*.cpp)
    get_filename_component(folder ${file} DIRECTORY)
    file(MAKE_DIRECTORY ${folder})
    add_custom_command(OUTPUT ${file}
        COMMAND known_mistakes ${PROJECT_SOURCE_DIR} ${suite} ${ARGN} > ${file}
        DEPENDS known_mistakes ${PROJECT_SOURCE_DIR}/tests/mistakes/${suite}.txt ${right}
        VERBATIM)
endfunction()

# raysteps_known_mistakes(<variable> <folder> <stage/name>...): the sources of these mistakes.
function(raysteps_known_mistakes variable folder)
    set(files)
    foreach(mistake IN LISTS ARGN)
        list(APPEND files ${folder}/${mistake}.cpp)
        string(REPLACE "/" ";" words ${mistake})
        raysteps_known_mistake(${folder}/${mistake}.cpp ${words})
    endforeach()
    set(${variable} ${files} PARENT_SCOPE)
endfunction()

# raysteps_answers(<suite> <folder>): the tests mistake_<suite>_<name>_double, and
# alternative_<suite>_<name>_float and _double: the suite, linked to all known mistakes and, from this
# folder, all other right answers. Float shows no more about mistakes than double: only the suite's
# first is tested in float, too, or with -DRAYSTEPS_MISTAKES=both all are.
function(raysteps_answers suite folder)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/answers/${suite}.cpp)
    raysteps_known_mistake(${source} ${suite})
    raysteps_compile_twice(${suite}_answers ${source})
    raysteps_both(raysteps_compile_without_optimizing ${suite}_answers_@ @)
    raysteps_both(target_compile_options ${suite}_answers_@ PRIVATE -w)  # they are wrong on purpose
    raysteps_both(raysteps_link_suite ${suite}_answers_test_@word ${suite}_test_@word_objects
        @ ${suite}_answers ${suite}_context)

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
    file(GLOB alternatives CONFIGURE_DEPENDS alternatives/${folder}/*.cpp)
    foreach(file IN LISTS alternatives)  # all of the suite must pass
        get_filename_component(name ${file} NAME_WE)
        foreach(word IN ITEMS float double)
            raysteps_add_test(alternative_${suite}_${name}_${word} alternatives
                "ENVIRONMENT;RAYSTEPS_ANSWER=${name}" ${suite}_answers_test_${word})
        endforeach()
    endforeach()
endfunction()
