# For what tests compile once and run briefly: three quarters of the time of -O2.
set(quickly $<$<CONFIG:Release>:-O1>)

# raysteps_add_test(<name> <label> <properties> <command>...): its words contain no semicolon.
function(raysteps_add_test name label properties)
    add_test(NAME ${name} COMMAND ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS "${label}" ${properties})
endfunction()

# raysteps_test_program(<name> <option of raysteps_target>...): a program of test cases that call no stage.
# raysteps_test(<name> <label> <option>...): the test <name>, which runs this program.
function(raysteps_test_program name)
    raysteps_target(${name}_test ${ARGN} OPTIONS ${quickly} HEADERS raysteps_kit_f64)
    target_link_libraries(${name}_test PRIVATE raysteps_kit_main raysteps_kit_options)
endfunction()
function(raysteps_test name label)
    raysteps_test_program(${name} ${ARGN})
    raysteps_add_test(${name} "${label}" "" ${name}_test)
endfunction()

# raysteps_suite_objects(<name> <precision> <source>... [<option of raysteps_target>...]): objects of test
# cases, which start from the kit's precompiled header.
function(raysteps_suite_objects name precision)
    raysteps_target(${name} OBJECT SOURCES ${ARGN} OPTIONS ${quickly}
        LIBRARIES raysteps_kit_options HEADERS raysteps_kit_${precision})
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

# raysteps_suite(<name> [SANITIZED_IN_DOUBLE] [LABEL <label>] [STAGES <name>...] [SOURCES <source>...]
#     [DOUBLE <source>...]): the suite <name>_float and <name>_double: the sources, compiled as one, with
# that precision as Real, linked to STAGES, by default raysteps_stages. With sanitizers it is built in
# double only if it is SANITIZED_IN_DOUBLE; those in DOUBLE test nothing with a Real in it.
function(raysteps_suite name)
    cmake_parse_arguments(PARSE_ARGV 1 suite "SANITIZED_IN_DOUBLE" "LABEL" "STAGES;SOURCES;DOUBLE")
    if(NOT suite_LABEL)
        set(suite_LABEL common)
    endif()
    if(NOT suite_STAGES)
        set(suite_STAGES raysteps_stages)
    endif()
    set(sources_f32 ${suite_SOURCES})
    set(sources_f64 ${suite_DOUBLE} ${suite_SOURCES})
    if(NOT sources_f64 MATCHES "[;*]")
        set(apart APART)
    endif()
    foreach(precision IN ITEMS f32 f64)
        if(precision STREQUAL f32 AND (NOT suite_SOURCES OR (RAYSTEPS_SANITIZE AND suite_SANITIZED_IN_DOUBLE)))
            continue()
        endif()
        set(program ${name}_test_${word_${precision}})
        raysteps_suite_objects(${program}_objects ${precision} ${sources_${precision}} ${apart})
        raysteps_link_suite(${program} ${program}_objects ${suite_STAGES})
        raysteps_add_test(${name}_${word_${precision}} ${suite_LABEL} "" ${program})
    endforeach()
endfunction()

# raysteps_stage_suite(<stage>): the suite of a stage, with the student's own tests, and that of its
# `trace` (<stage>_trace), if there is one: the chosen file, with the references of the stages before
# it, so that a first check compiles no others. <suite>_context_f32 and _f64 are all that a program
# needs beside that file if it calls all stages. `./course check` waits for the line that
# <stage>_suites_float and _double print.
function(raysteps_stage_suite stage)
    set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
    get_property(before GLOBAL PROPERTY RAYSTEPS_STAGES_OF_${stage})
    list(TRANSFORM before APPEND _reference)
    set(others ${references})
    list(REMOVE_ITEM before ${stage}_reference)
    list(REMOVE_ITEM others ${stage}_reference)
    raysteps_collect(${stage}_context raysteps_common ${stage}_picture ${others})

    get_property(suite GLOBAL PROPERTY RAYSTEPS_SUITE_${stage})
    list(TRANSFORM suite REPLACE "(.+)" "suites/${stage}/\\1_test.cpp")
    if(NOT suite)
        set(suite suites/${stage}_test.cpp)
    endif()
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

# raysteps_course_suites(<stage>): the stage's workers, and its suites for `./course`: with options for
# debugging, with a worker, and on the starter.
function(raysteps_course_suites stage)
    raysteps_worker(${stage}_reference_worker "" ${stage}_reference ${stage}_context)
    raysteps_worker(${stage}_worker_double "" ${stage} ${stage}_context)
    raysteps_worker(${stage}_worker_float "" ${stage} ${stage}_context ON_DEMAND)
    file(GLOB functions ${step}/student/*.cpp)
    set(mains ${functions})
    list(FILTER functions EXCLUDE REGEX "/main\\.cpp$")
    list(FILTER mains INCLUDE REGEX "/main\\.cpp$")
    foreach(suite IN LISTS suites)
        set(parts ${stage}_picture)
        set(files ${functions})
        if(suite MATCHES "_trace$")
            set(parts ${stage}_reference ${stage}_picture_without_main)
            set(files ${mains})
        endif()
        if(files)
            raysteps_variant(debug -O0 -g -finstrument-functions
                $<$<CXX_COMPILER_ID:GNU>:-finstrument-functions-exclude-file-list=/usr/,common/>)
            raysteps_variant(sanitized -O1 -g -fsanitize=address,undefined
                -fno-sanitize-recover=all -fno-omit-frame-pointer)
            raysteps_both(target_sources ${suite}_debug_@word PRIVATE
                ${CMAKE_CURRENT_SOURCE_DIR}/kit/failing_call.cpp)
        endif()
    endforeach()
    if(EXISTS ${PROJECT_SOURCE_DIR}/steps/handout.txt)
        return()  # which has no stubs, nor every starter
    endif()
    raysteps_asked_suite(${stage} ${stage}_worker_double ${stage}_context)
    raysteps_other_answers(${stage} starter ON_DEMAND ${step}/starter/*.cpp EXCEPT main)
    if(TARGET ${stage}_trace_test_double)
        raysteps_asked_suite(${stage}_trace ${stage}_reference_worker
            raysteps_common raysteps_references ${stage}_picture)
        raysteps_other_answers(${stage}_trace starter ON_DEMAND ${step}/starter/main.cpp)
    endif()
endfunction()

# raysteps_variant(<word> <option>...): <suite>_<word>_float and _double: the suite of a student's files,
# which are compiled and linked with these options. `./course debug` and `check --sanitize` build them by
# name.
function(raysteps_variant word)
    set(with_symbols ON)
    raysteps_compile_twice(${suite}_${word}_student ${files} ON_DEMAND
        OPTIONS ${students_errors} ${ARGN} DEFINITIONS ${students_assertions})
    raysteps_both(raysteps_link_suite ${suite}_${word}_@word ${suite}_test_@word_objects
        ${suite}_${word}_student raysteps_common ${before} ${parts} ON_DEMAND)
    raysteps_both(target_link_options ${suite}_${word}_@word PRIVATE ${ARGN})
endfunction()

# raysteps_other_answers(<suite> <word> <ON_DEMAND or ""> <source>...): <suite>_<word>_test_float and
# _double: the suite, linked to these sources, <suite>_<word>_f32 and _f64, in place of the stage's file.
function(raysteps_other_answers suite word on_demand)
    raysteps_compile_twice(${suite}_${word} ${ARGN} ${on_demand} OPTIONS -O0 HEADERS raysteps_unoptimized_@)
    raysteps_both(raysteps_link_suite ${suite}_${word}_test_@word ${suite}_test_@word_objects
        ${suite}_${word} ${suite}_context ${on_demand})
endfunction()

# raysteps_known_mistakes(<variable> <folder> <suite[/name]>...): the sources of these mistakes of
# mistakes/<suite>.txt or right answers of alternatives/<suite>.cpp; without a name, of all of them, of
# which RAYSTEPS_ANSWER selects one.
function(raysteps_known_mistakes variable folder)
    set(tests ${PROJECT_SOURCE_DIR}/tests)
    foreach(mistake IN LISTS ARGN)
        string(REPLACE "/" ";" words ${mistake})
        list(GET words 0 suite)
        string(REGEX REPLACE "_trace$" "" stage ${suite})
        set(step ${PROJECT_SOURCE_DIR}/steps/${stage})
        file(GLOB right ${tests}/alternatives/${suite}.cpp ${step}/main.cpp ${step}/reference/*.cpp)
        file(MAKE_DIRECTORY ${folder}/${suite})
        add_custom_command(OUTPUT ${folder}/${mistake}.cpp
            COMMAND known_mistakes ${PROJECT_SOURCE_DIR} ${words} > ${folder}/${mistake}.cpp
            DEPENDS known_mistakes ${tests}/mistakes/${suite}.txt ${right} VERBATIM)
        list(APPEND files ${folder}/${mistake}.cpp)
    endforeach()
    set(${variable} ${files} PARENT_SCOPE)
endfunction()

# raysteps_answers(<suite>): the tests mistake_<suite>_<name>_double, and
# alternative_<suite>_<name>_float and _double: the suite, linked to all known mistakes and all other
# right answers. Float shows no more about mistakes than double: only the suite's first is tested in
# float, too.
function(raysteps_answers suite)
    raysteps_known_mistakes(source ${CMAKE_CURRENT_BINARY_DIR}/answers ${suite})
    raysteps_other_answers(${suite} answers "" ${source})
    raysteps_both(target_compile_options ${suite}_answers_@ PRIVATE -w)  # they are wrong on purpose

    file(GLOB catalogues mistakes/${suite}.txt alternatives/${suite}.cpp)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${catalogues})
    foreach(catalogue IN LISTS catalogues)
        file(STRINGS ${catalogue} more REGEX "^(mistake|caught by:|// right) " ENCODING UTF-8)
        list(APPEND lines "${more}")
    endforeach()
    set(words float double)
    foreach(line IN LISTS lines)
        if(line MATCHES "^// right ([a-z0-9_]+)[ :]")  # all of the suite must pass
            set(name ${CMAKE_MATCH_1})
            foreach(word IN ITEMS float double)
                raysteps_add_test(alternative_${suite}_${name}_${word} alternatives
                    "ENVIRONMENT;RAYSTEPS_ANSWER=${name}" ${suite}_answers_test_${word})
            endforeach()
        elseif(line MATCHES "^mistake ([a-z0-9_]+) ")
            set(name ${CMAKE_MATCH_1})
        elseif(line MATCHES "^caught by: (.*)")
            string(REGEX REPLACE "([][,*\\\\~])" "\\\\\\1" case "${CMAKE_MATCH_1}")  # for Catch2
            foreach(word IN LISTS words)  # it fails by an assertion: a missing case, or a crash, does not count
                raysteps_add_test(mistake_${suite}_${name}_${word} mistakes
                    "ENVIRONMENT;RAYSTEPS_ANSWER=${name};TIMEOUT;300;PASS_REGULAR_EXPRESSION;${fails}"
                    ${suite}_answers_test_${word} "${case}")
            endforeach()
            set(words double)
        endif()
    endforeach()
endfunction()
set(fails "test cases: +1 \\|( +0 passed \\|)? +1 failed")
