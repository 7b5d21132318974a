# raysteps_suite(<name> <source>...)
#
# The suite <name>_float and <name>_double: the sources, with that precision as Real, in one program
# each, linked to the stages in STAGES (chosen or _reference) and to their dependencies.
function(raysteps_suite name)
    cmake_parse_arguments(PARSE_ARGV 1 suite "" "LABEL" "STAGES;SOURCES")
    foreach(precision IN ITEMS f32 f64)
        set(word_f32 float)
        set(word_f64 double)
        set(program ${name}_test_${word_${precision}})
        add_library(${program}_objects OBJECT ${suite_SOURCES})
        target_link_libraries(${program}_objects PRIVATE raysteps_kit_${precision}_options)
        target_precompile_headers(${program}_objects REUSE_FROM raysteps_kit_${precision})
        raysteps_link_suite(${program} ${program}_objects ${precision} ${suite_STAGES})
        add_test(NAME ${name}_${word_${precision}} COMMAND ${program})
        set_tests_properties(${name}_${word_${precision}} PROPERTIES LABELS "${suite_LABEL}")
    endforeach()
endfunction()

# raysteps_link_suite(<program> <objects> <precision> <stage>...)
function(raysteps_link_suite program objects precision)
    add_executable(${program} $<TARGET_OBJECTS:${objects}>)
    target_link_libraries(${program} PRIVATE
        raysteps_common_${precision} raysteps_kit_${precision} raysteps_drawn_${precision}
        raysteps_kit_main raysteps_base Threads::Threads)
    foreach(stage IN LISTS ARGN)
        target_link_libraries(${program} PRIVATE ${stage}_${precision})
    endforeach()
endfunction()

# The suites of several files, tests/suites/<stage>/<part>_test.cpp: their cases run, and are
# reported, in the order of the parts.
set(step11_soft_shadows_parts light_points visibility scenes)
set(step12_mirror_parts reflected_ray self_intersection reflections)
set(step13_meshes_parts boxes frames meshes scenes)

# raysteps_stage_suite(<stage>)
#
# The suite of a stage, and the student's own tests: the chosen file, with the references of all
# others.
function(raysteps_stage_suite stage)
    get_property(stages GLOBAL PROPERTY RAYSTEPS_STAGES)
    list(TRANSFORM stages APPEND _reference)
    list(REMOVE_ITEM stages ${stage}_reference)
    set(suite ${stage})
    if(DEFINED ${stage}_parts)
        list(TRANSFORM ${stage}_parts PREPEND ${stage}/ OUTPUT_VARIABLE suite)
    endif()
    list(TRANSFORM suite REPLACE "(.+)" "suites/\\1_test.cpp")
    file(GLOB own_tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${stage}/student/tests/*.cpp)
    raysteps_suite(${stage} LABEL ${stage} SOURCES ${suite} ${own_tests}
        STAGES ${stage} ${stage}_picture ${stages})
    if(TARGET course)
        raysteps_contract(${stage} ${stages})
    endif()
    file(GLOB starter CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/${stage}/starter/*.cpp)
    list(FILTER starter EXCLUDE REGEX "/main\\.cpp$")
    raysteps_starter(${stage} "${starter}" ${stages} ${stage}_picture)
    raysteps_trace_suite(${stage} ${stages} ${stage}_reference)
    if(NOT RAYSTEPS_MISTAKES)
        return()
    endif()
    file(GLOB mistakes CONFIGURE_DEPENDS mistakes/${stage}/*.cpp)
    foreach(mistake IN LISTS mistakes)
        raysteps_mistake(${stage} ${mistake} ${stages} ${stage}_picture)
    endforeach()
    file(GLOB alternatives CONFIGURE_DEPENDS alternatives/${stage}/*.cpp)
    foreach(alternative IN LISTS alternatives)
        raysteps_alternative(${stage} ${alternative} ${stages} ${stage}_picture)
    endforeach()
    if(TARGET course)
        raysteps_recognition(${stage} "${mistakes}" "${alternatives}" ${stages} ${stage}_picture)
    endif()
endfunction()

# raysteps_trace_suite(<stage> <reference>...)
#
# <stage>_trace_test_float and _double, from stage 3 on: the chosen main.cpp, with the references of
# all stages.
function(raysteps_trace_suite stage)
    set(suite suites/${stage}_trace_test.cpp)
    if(NOT EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${suite})
        return()
    endif()
    raysteps_suite(${stage}_trace LABEL ${stage} SOURCES ${suite}
        STAGES ${stage}_chosen_picture ${ARGN})
    set(others ${stage}_picture_without_main ${ARGN})
    raysteps_starter(${stage}_trace
        ${PROJECT_SOURCE_DIR}/steps/${stage}/starter/main.cpp ${others})
    if(NOT RAYSTEPS_MISTAKES)
        return()
    endif()
    foreach(kind IN ITEMS mistake alternative)
        file(GLOB answers CONFIGURE_DEPENDS ${kind}s/${stage}/main/*.cpp)
        foreach(answer IN LISTS answers)
            cmake_language(CALL raysteps_${kind} ${stage}_trace ${answer} ${others})
        endforeach()
    endforeach()
endfunction()

# raysteps_starter(<suite> <sources> <other stages>...)
#
# <suite>_starter_test_float and _double: the suite, linked to the stage's starter, for `./course
# audit`.
function(raysteps_starter suite sources)
    raysteps_compile_twice(${suite}_starter ${sources})
    foreach(precision IN ITEMS f32 f64)
        set(word_f32 float)
        set(word_f64 double)
        set(word ${word_${precision}})
        raysteps_link_suite(${suite}_starter_test_${word} ${suite}_test_${word}_objects
            ${precision} ${suite}_starter ${ARGN})
        set_target_properties(${suite}_starter_test_${word} PROPERTIES EXCLUDE_FROM_ALL ON)
    endforeach()
endfunction()

# raysteps_alternative(<stage> <file> <other stages>...)
#
# The stage's suite, linked to another right answer: all of it must pass.
function(raysteps_alternative stage file)
    get_filename_component(alternative ${file} NAME_WE)
    raysteps_compile_twice(${stage}_${alternative} ${file})
    raysteps_start_from_common(${stage}_${alternative})
    foreach(precision IN ITEMS f32 f64)
        target_compile_options(${stage}_${alternative}_${precision} PRIVATE -w)  # from its renaming
        set(word_f32 float)
        set(word_f64 double)
        set(word ${word_${precision}})
        set(name alternative_${stage}_${alternative}_${word})
        raysteps_link_suite(${name} ${stage}_test_${word}_objects ${precision}
            ${stage}_${alternative} ${ARGN})
        set_target_properties(${name} PROPERTIES
            RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/alternatives)
        add_test(NAME ${name} COMMAND ${name})
        set_tests_properties(${name} PROPERTIES LABELS "alternatives")
    endforeach()
endfunction()

# raysteps_mistake(<stage> <file> <other stages>...)
#
# The stage's suite, linked to a known mistake: the case that the file names must fail.
function(raysteps_mistake stage file)
    get_filename_component(mistake ${file} NAME_WE)
    file(STRINGS ${file} case REGEX "^// caught by: " LIMIT_COUNT 1 ENCODING UTF-8)
    string(REGEX REPLACE "^// caught by: " "" case "${case}")
    if(case STREQUAL "")
        message(FATAL_ERROR "${file} does not say \"// caught by: <test case>\"")
    endif()
    # escaped for Catch2, and no ";" for CMake
    string(REGEX REPLACE "([][,*\\\\~])" "\\\\\\1" case "${case}")
    raysteps_compile_twice(${stage}_${mistake} ${file})
    raysteps_start_from_common(${stage}_${mistake})
    target_compile_options(${stage}_${mistake}_f32 PRIVATE -w)  # it is wrong on purpose
    target_compile_options(${stage}_${mistake}_f64 PRIVATE -w)
    foreach(precision IN ITEMS f32 f64)
        set(word_f32 float)
        set(word_f64 double)
        set(word ${word_${precision}})
        set(name mistake_${stage}_${mistake}_${word})
        raysteps_link_suite(${name} ${stage}_test_${word}_objects ${precision}
            ${stage}_${mistake} ${ARGN})
        set_target_properties(${name} PROPERTIES
            RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/mistakes)
        add_test(NAME ${name} COMMAND ${name} "${case}")
        # By failing an assertion: a missing case, or a crash, does not count.
        set_tests_properties(${name} PROPERTIES
            LABELS "mistakes" PASS_REGULAR_EXPRESSION "test cases: +1 \\| +1 failed")
    endforeach()
endfunction()
