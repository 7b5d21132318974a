# For what tests compile once and run briefly: three quarters of the time of -O2.
set(quickly $<$<CONFIG:Release>:-O1>)

# raysteps_suite_objects(<name> <precision> <source>...)
#
# An object library of test cases, which starts from the precompiled header of the kit, or of
# another library: ${suite_headers}_f32 or _f64.
function(raysteps_suite_objects name precision)
    add_library(${name} OBJECT ${ARGN})
    target_link_libraries(${name} PRIVATE raysteps_kit_${precision}_options)
    target_compile_options(${name} PRIVATE ${quickly})
    if(NOT suite_headers)
        set(suite_headers raysteps_kit)
    endif()
    target_precompile_headers(${name} REUSE_FROM ${suite_headers}_${precision})
endfunction()

# raysteps_link_suite(<program> <objects> <precision> <name>...)
#
# The program of these test cases, linked to <name>_f32 or _f64 of each name.
function(raysteps_link_suite program objects precision)
    add_executable(${program} $<TARGET_OBJECTS:${objects}>)
    raysteps_link(${program} ${precision} raysteps_kit raysteps_drawn ${ARGN})
    target_link_libraries(${program} PRIVATE raysteps_kit_main)
    if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND NOT RAYSTEPS_SANITIZE)  # 1.4 of 3.6 MB are symbols
        target_link_options(${program} PRIVATE $<$<CONFIG:Release>:-s>)
    endif()
endfunction()

# raysteps_suite(<name> [SANITIZED_IN_DOUBLE] [LABEL <label>] [PICTURE <stage> | STAGES <name>...]
#                SOURCES <source>...)
#
# The suite <name>_float and <name>_double: the sources, with that precision as Real, in one program
# each, linked to STAGES: by default all references and the picture of a stage, step12_mirror.
# SANITIZED_IN_DOUBLE: with sanitizers, it is built in double only. Several sources are compiled as
# one, in two thirds of the time, but for those with the property SKIP_UNITY_BUILD_INCLUSION.
function(raysteps_suite name)
    cmake_parse_arguments(PARSE_ARGV 1 suite "SANITIZED_IN_DOUBLE" "LABEL;PICTURE" "STAGES;SOURCES")
    if(NOT suite_LABEL)
        set(suite_LABEL common)
    endif()
    if(NOT suite_PICTURE)
        set(suite_PICTURE step12_mirror)
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
        set(word ${word_${precision}})
        raysteps_suite_objects(${name}_test_${word}_objects ${precision} ${suite_SOURCES})
        if(files GREATER 1 AND NOT DEFINED CMAKE_UNITY_BUILD)
            set_target_properties(${name}_test_${word}_objects PROPERTIES
                UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
        endif()
        raysteps_link_suite(${name}_test_${word} ${name}_test_${word}_objects ${precision}
            ${suite_STAGES})
        add_test(NAME ${name}_${word} COMMAND ${name}_test_${word})
        set_tests_properties(${name}_${word} PROPERTIES LABELS ${suite_LABEL})
    endforeach()
endfunction()

# raysteps_test(<name> [LABEL <label>] SOURCES <source>... LIBRARIES <library>...
#               [DEFINITIONS <definition>...] [NEEDS <target>...] [CASES <pattern>])
#
# The test <name>, a program of test cases that call no stage. NEEDS are built before it. CASES are
# those that the test runs, by default all.
function(raysteps_test name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "LABEL;CASES" "")
    raysteps_test_program(${name} ${test_UNPARSED_ARGUMENTS})
    add_test(NAME ${name} COMMAND ${name}_test ${test_CASES})
    set_tests_properties(${name} PROPERTIES LABELS "${test_LABEL}")
endfunction()

# The program alone: raysteps_test_program(<name> SOURCES <source>... LIBRARIES <library>...
#                                          [DEFINITIONS <definition>...] [NEEDS <target>...])
function(raysteps_test_program name)
    cmake_parse_arguments(PARSE_ARGV 1 test "" "" "SOURCES;LIBRARIES;DEFINITIONS;NEEDS")
    add_executable(${name}_test ${test_SOURCES})
    target_link_libraries(${name}_test PRIVATE
        ${test_LIBRARIES} raysteps_kit_main raysteps_kit_f64_options)
    target_compile_definitions(${name}_test PRIVATE ${test_DEFINITIONS})
    target_compile_options(${name}_test PRIVATE ${quickly})
    target_precompile_headers(${name}_test REUSE_FROM raysteps_kit_f64)
    if(test_NEEDS)
        add_dependencies(${name}_test ${test_NEEDS})
    endif()
endfunction()

# The suites of several files, tests/suites/<stage>/<part>_test.cpp: their cases run, and are
# reported, in the order of the parts.
set(step09_phong_parts terms scenes)
set(step10_shadows_parts shadow_ray scenes)
set(step11_soft_shadows_parts light_points visibility scenes)
set(step12_mirror_parts reflected_ray self_intersection reflections)
set(step13_meshes_parts boxes oriented_boxes frames meshes scenes)

# raysteps_stage_suite(<stage>)
#
# The suite of a stage, and the student's own tests: the chosen file, with the references of the
# stages before it, so that a first check compiles no others. <stage>_context_f32 and _f64 are
# everything that a program needs beside that file if it calls all stages.
# <stage>_suites_float and _double build this suite and that of `trace`; `./course check` waits for
# the line that they print then.
function(raysteps_stage_suite stage)
    set(others ${stages})
    list(REMOVE_ITEM others ${stage})
    list(TRANSFORM others APPEND _reference)
    raysteps_collect(${stage}_context raysteps_common ${stage}_picture ${others})
    get_property(always GLOBAL PROPERTY RAYSTEPS_IN_EVERY_PROGRAM)
    list(TRANSFORM always APPEND _reference OUTPUT_VARIABLE before)
    list(REMOVE_ITEM before ${stage}_reference)
    foreach(other IN LISTS others)
        if(other STRLESS stage AND NOT other IN_LIST before)
            list(APPEND before ${other})
        endif()
    endforeach()

    set(suite ${stage})
    if(DEFINED ${stage}_parts)
        list(TRANSFORM ${stage}_parts PREPEND ${stage}/ OUTPUT_VARIABLE suite)
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
        raysteps_contract(${stage})
    endif()
    raysteps_trace_suite(${stage})
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

# raysteps_trace_suite(<stage>)
#
# <stage>_trace_test_float and _double, in stage 1 and from stage 3 on: the chosen main.cpp, with the
# references of its stage and of those before it.
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
        raysteps_trace_contract(${stage})
    endif()
    if(RAYSTEPS_MISTAKES)
        raysteps_answers(${stage}_trace ${stage}/main)
        if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage}/trace.txt)
            add_test(NAME recognition_${stage}_trace COMMAND sh
                ${PROJECT_SOURCE_DIR}/tests/trace_mistakes.sh check ${PROJECT_BINARY_DIR}
                ${PROJECT_SOURCE_DIR} ${stage})
            set_tests_properties(recognition_${stage}_trace PROPERTIES LABELS mistakes)
        endif()
    endif()
endfunction()

# raysteps_starter(<suite> <source>...)
#
# <suite>_starter_test_float and _double: the suite, linked to the stage's starter, for `./course
# audit`.
function(raysteps_starter suite)
    raysteps_compile_twice(${suite}_starter ${ARGN})
    set_target_properties(${suite}_starter_f32 ${suite}_starter_f64 PROPERTIES EXCLUDE_FROM_ALL ON)
    foreach(precision IN ITEMS f32 f64)
        raysteps_compile_without_optimizing(${suite}_starter_${precision} ${precision})
        set(word ${word_${precision}})
        raysteps_link_suite(${suite}_starter_test_${word} ${suite}_test_${word}_objects
            ${precision} ${suite}_starter ${suite}_context)
        set_target_properties(${suite}_starter_test_${word} PROPERTIES EXCLUDE_FROM_ALL ON)
    endforeach()
endfunction()

# raysteps_known_mistake(<file> <suite> [<name>])
#
# The source of one mistake of mistakes/<suite>.txt, or of all of them and of the other right answers,
# of which RAYSTEPS_ANSWER selects one.
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

# raysteps_answers(<suite> <folder>)
#
# The tests mistake_<suite>_<name>_double, and alternative_<suite>_<name>_float and _double: the suite,
# linked to all known mistakes and, from this folder, all other right answers. Float shows no more
# about mistakes than double: only the suite's first is tested in float, too, or with
# -DRAYSTEPS_MISTAKES=both all are.
function(raysteps_answers suite folder)
    set(source ${CMAKE_CURRENT_BINARY_DIR}/answers/${suite}.cpp)
    raysteps_known_mistake(${source} ${suite})
    raysteps_compile_twice(${suite}_answers ${source})
    foreach(precision IN ITEMS f32 f64)
        set(objects ${suite}_answers_${precision})
        raysteps_compile_without_optimizing(${objects} ${precision})
        target_compile_options(${objects} PRIVATE -w)  # they are wrong on purpose
        set(program ${suite}_answers_test_${word_${precision}})
        raysteps_link_suite(${program} ${suite}_test_${word_${precision}}_objects ${precision}
            ${suite}_answers ${suite}_context)
    endforeach()

    set(catalogue ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${suite}.txt)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${catalogue})
    file(STRINGS ${catalogue} lines REGEX "^(mistake|caught by:) " ENCODING UTF-8)
    set(words float double)
    foreach(line IN LISTS lines)
        if(line MATCHES "^mistake ([a-z0-9_]+) ")
            set(name ${CMAKE_MATCH_1})
            continue()
        endif()
        string(REGEX REPLACE "^caught by: " "" case "${line}")
        string(REGEX REPLACE "([][,*\\\\~])" "\\\\\\1" case "${case}")  # for Catch2
        foreach(word IN LISTS words)
            raysteps_test_answer(mistake ${suite} ${name} ${word} "${case}")
            # It fails by an assertion: a missing case, or a crash, does not count.
            set_tests_properties(mistake_${suite}_${name}_${word} PROPERTIES TIMEOUT 300
                PASS_REGULAR_EXPRESSION "test cases: +1 \\|( +0 passed \\|)? +1 failed")
        endforeach()
        if(NOT RAYSTEPS_MISTAKES STREQUAL "both")
            set(words double)
        endif()
    endforeach()
    file(GLOB alternatives CONFIGURE_DEPENDS alternatives/${folder}/*.cpp)
    foreach(file IN LISTS alternatives)  # all of the suite must pass
        get_filename_component(name ${file} NAME_WE)
        raysteps_test_answer(alternative ${suite} ${name} float)
        raysteps_test_answer(alternative ${suite} ${name} double)
    endforeach()
endfunction()

# raysteps_test_answer(<kind> <suite> <name> <precision's word> [<case>])
function(raysteps_test_answer kind suite name word)
    set(test ${kind}_${suite}_${name}_${word})
    add_test(NAME ${test} COMMAND ${suite}_answers_test_${word} ${ARGN})
    set_tests_properties(${test} PROPERTIES LABELS ${kind}s ENVIRONMENT RAYSTEPS_ANSWER=${name})
endfunction()
