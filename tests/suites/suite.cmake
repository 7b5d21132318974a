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
    if(NOT suite_headers)
        set(suite_headers raysteps_kit)
    endif()
    add_library(${name} OBJECT ${ARGN})
    target_link_libraries(${name} PRIVATE raysteps_kit_${precision}_options)
    target_compile_options(${name} PRIVATE ${quickly})
    target_precompile_headers(${name} REUSE_FROM ${suite_headers}_${precision})
endfunction()

# raysteps_link_suite(<program> <objects> <precision> <name>...): the program of these test cases,
# linked to <name>_f32 or _f64 of each name. Of 3.6 MB, 1.4 would be symbols.
function(raysteps_link_suite program objects precision)
    add_executable(${program} $<TARGET_OBJECTS:${objects}>)
    raysteps_link(${program} ${precision} raysteps_kit raysteps_drawn ${ARGN})
    target_link_libraries(${program} PRIVATE raysteps_kit_main)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT RAYSTEPS_SANITIZE AND NOT with_symbols)
        target_link_options(${program} PRIVATE $<$<CONFIG:Release>:-s>)
    endif()
endfunction()

# raysteps_suite(<name> [SANITIZED_IN_DOUBLE] [LABEL <label>] [PICTURE <stage> | STAGES <name>...]
#     SOURCES <source>...): the suite <name>_float and <name>_double: the sources, with that precision
# as Real, in one program each, linked to STAGES: by default all references and the picture of the
# last stage that needs no meshes. SANITIZED_IN_DOUBLE: with sanitizers, it is built in double only.
# Sources are compiled as one, but for those with the property SKIP_UNITY_BUILD_INCLUSION.
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
    foreach(precision IN ITEMS f32 f64)
        if(precision STREQUAL f32 AND suite_SANITIZED_IN_DOUBLE AND RAYSTEPS_SANITIZE)
            continue()
        endif()
        set(program ${name}_test_${word_${precision}})
        raysteps_suite_objects(${program}_objects ${precision} ${suite_SOURCES})
        if(files GREATER 1)
            raysteps_compile_whole(${program}_objects)
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

# raysteps_stage_suite(<stage>): the suite of a stage, with the student's own tests, and that of its
# `trace`, if there is one (<stage>_trace): the chosen file, with the references of the stages before
# it, so that a first check compiles no others. <suite>_context_f32 and _f64 are all that a program
# needs beside that file if it calls all stages. <stage>_suites_float and _double build both suites;
# `./course check` waits for the line that they print then.
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

    set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
    get_property(suite GLOBAL PROPERTY RAYSTEPS_SUITE_${stage})
    list(TRANSFORM suite PREPEND ${stage}/)
    if(NOT suite)
        set(suite ${stage})
    endif()
    list(TRANSFORM suite REPLACE "(.+)" "suites/\\1_test.cpp")
    file(GLOB own_tests CONFIGURE_DEPENDS ${step}/student/tests/*.cpp)
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
        add_custom_target(${both} COMMAND ${CMAKE_COMMAND} -E true COMMENT ${both})
        foreach(suite IN LISTS suites)
            if(TARGET ${suite}_test_${word})
                add_dependencies(${both} ${suite}_test_${word})
            endif()
        endforeach()
    endforeach()
    if(TARGET course)
        raysteps_course_suites(${stage})
    endif()
    if(RAYSTEPS_MISTAKES)
        raysteps_answers(${stage} ${stage})
        if(TARGET ${stage}_trace_test_double)
            raysteps_answers(${stage}_trace ${stage}/main)
        endif()
        if(TARGET course)
            raysteps_recognition(${stage})
        endif()
    endif()
endfunction()

# raysteps_course_suites(<stage>): the stage's workers, and its suites for `./course`: on the starter,
# with a worker, and with options for debugging.
function(raysteps_course_suites stage)
    raysteps_workers(${stage})
    file(GLOB starter CONFIGURE_DEPENDS ${step}/starter/*.cpp)
    list(FILTER starter EXCLUDE REGEX "/main\\.cpp$")
    raysteps_starter(${stage} ${starter})
    if(COMMAND raysteps_asked_suite)  # not in a hand-out
        raysteps_asked_suite(${stage} ${stage}_worker_double ${stage}_context)
    endif()
    if(TARGET ${stage}_trace_test_double)
        raysteps_starter(${stage}_trace ${step}/starter/main.cpp)
        if(COMMAND raysteps_asked_suite)
            raysteps_asked_suite(${stage}_trace ${stage}_reference_worker
                raysteps_common raysteps_references ${stage}_picture)
        endif()
    endif()
    raysteps_variant(${stage} debug -O0 -g -finstrument-functions
        $<$<CXX_COMPILER_ID:GNU>:-finstrument-functions-exclude-file-list=/usr/,common/>)
    raysteps_variant(${stage} sanitized -O1 -g -fsanitize=address,undefined
        -fno-sanitize-recover=all -fno-omit-frame-pointer)
endfunction()

# raysteps_variant(<stage> <word> <option>...): <stage>_<word>_float and _double, and with a student's
# main.cpp <stage>_trace_<word>_float and _double: the suites of a student's files, which are compiled
# and linked with these options. `./course debug` and `check --sanitize` build them by name.
function(raysteps_variant stage word)
    set(with_symbols ON)
    file(GLOB files_of_${stage}_trace CONFIGURE_DEPENDS ${step}/student/main.cpp)
    file(GLOB files_of_${stage} CONFIGURE_DEPENDS ${step}/student/*.cpp)
    list(REMOVE_ITEM files_of_${stage} "" ${files_of_${stage}_trace})
    set(others_of_${stage} ${stage}_picture)
    set(others_of_${stage}_trace ${stage}_reference ${stage}_picture_without_main)
    foreach(suite IN ITEMS ${stage} ${stage}_trace)
        if(NOT files_of_${suite} OR NOT TARGET ${suite}_test_double)
            continue()
        endif()
        set(own ${suite}_${word}_student)
        raysteps_compile_twice(${own} ${files_of_${suite}})
        foreach(precision IN ITEMS f32 f64)
            set(program ${suite}_${word}_${word_${precision}})
            raysteps_link_suite(${program} ${suite}_test_${word_${precision}}_objects
                ${precision} ${own} raysteps_common ${before} ${others_of_${suite}})
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
    if(NOT EXISTS ${PROJECT_SOURCE_DIR}/steps/handout.txt)
        raysteps_other_answers(${suite} starter ${ARGN})
        raysteps_both(set_target_properties ${suite}_starter_@ ${suite}_starter_test_@word
            PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
endfunction()

# raysteps_other_answers(<suite> <word> <source>...): <suite>_<word>_test_float and _double: the suite,
# linked to these sources, <suite>_<word>_f32 and _f64, in place of the stage's file.
function(raysteps_other_answers suite word)
    raysteps_compile_twice(${suite}_${word} ${ARGN})
    raysteps_both(raysteps_compile_without_optimizing ${suite}_${word}_@ @)
    raysteps_both(raysteps_link_suite ${suite}_${word}_test_@word ${suite}_test_@word_objects
        @ ${suite}_${word} ${suite}_context)
endfunction()

# raysteps_known_mistakes(<variable> <folder> <stage[/name]>...): the sources of these mistakes of
# mistakes/<stage>.txt; without a name, of all of them and of the other right answers, of which
# RAYSTEPS_ANSWER selects one.
function(raysteps_known_mistakes variable folder)
    set(files)
    foreach(mistake IN LISTS ARGN)
        set(file ${folder}/${mistake}.cpp)
        list(APPEND files ${file})
        string(REPLACE "/" ";" words ${mistake})
        list(GET words 0 suite)
        string(REGEX REPLACE "_trace$" "" stage ${suite})
        set(alternatives ${PROJECT_SOURCE_DIR}/tests/alternatives/${stage})
        set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
        file(GLOB right CONFIGURE_DEPENDS
            ${alternatives}/*.cpp ${alternatives}/main/*.cpp ${step}/main.cpp ${step}/reference/*.cpp)
        get_filename_component(folder_of_file ${file} DIRECTORY)
        file(MAKE_DIRECTORY ${folder_of_file})
        add_custom_command(OUTPUT ${file}
            COMMAND known_mistakes ${PROJECT_SOURCE_DIR} ${words} > ${file}
            DEPENDS known_mistakes ${PROJECT_SOURCE_DIR}/tests/mistakes/${suite}.txt ${right}
            VERBATIM)
    endforeach()
    set(${variable} ${files} PARENT_SCOPE)
endfunction()

# raysteps_answers(<suite> <folder>): the tests mistake_<suite>_<name>_double, and
# alternative_<suite>_<name>_float and _double: the suite, linked to all known mistakes and, from this
# folder, all other right answers. Float shows no more about mistakes than double: only the suite's
# first is tested in float, too, or with -DRAYSTEPS_MISTAKES=both all are.
function(raysteps_answers suite folder)
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
    file(GLOB alternatives CONFIGURE_DEPENDS alternatives/${folder}/*.cpp)
    foreach(file IN LISTS alternatives)  # all of the suite must pass
        get_filename_component(name ${file} NAME_WE)
        foreach(word IN ITEMS float double)
            raysteps_add_test(alternative_${suite}_${name}_${word} alternatives
                "ENVIRONMENT;RAYSTEPS_ANSWER=${name}" ${suite}_answers_test_${word})
        endforeach()
    endforeach()
endfunction()
