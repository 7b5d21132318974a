# A stage's contract, called in another process: the workers, and the suites linked to stubs that
# call them. Targets without a precision in the name are in double.

# raysteps_worker(<program> <folder> <precision> <name>...)
#
# A worker linked to <name>_f32 or _f64 of each name.
function(raysteps_worker program folder precision)
    add_executable(${program})
    raysteps_link(${program} ${precision} raysteps_worker ${ARGN})
    set_target_properties(${program} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
endfunction()

# raysteps_contract(<stage>)
#
# <stage>_worker_float, _double  the chosen one
# <stage>_reference_worker       the reference
# <stage>_asked_test_double      the suite with a worker
function(raysteps_contract stage)
    raysteps_worker(${stage}_reference_worker "" f64 ${stage}_reference ${stage}_context)
    foreach(precision IN ITEMS f32 f64)
        set(word ${word_${precision}})
        raysteps_worker(${stage}_worker_${word} "" ${precision} ${stage} ${stage}_context)
    endforeach()
    set_target_properties(${stage}_worker_float PROPERTIES EXCLUDE_FROM_ALL ON)
    raysteps_suite_objects(${stage}_stubs f64 contract/stubs/${stage}.cpp)
    raysteps_asked_suite(${stage} ${stage}_worker_double $<TARGET_OBJECTS:${stage}_stubs> ${stage}_context)
endfunction()

# raysteps_trace_contract(<stage>)
#
# <stage>_trace_asked_test_double: the suite of `trace` with a worker
function(raysteps_trace_contract stage)
    raysteps_asked_suite(${stage}_trace ${stage}_reference_worker "" raysteps_common raysteps_references
        ${stage}_picture)
endfunction()

# raysteps_asked_suite(<suite> <worker> <stubs> <name>...)
#
# <suite>_asked_test_double and its test with this worker, linked to the stubs and <name>_f64 of each
# name.
function(raysteps_asked_suite suite worker stubs)
    set(program ${suite}_asked_test_double)
    add_executable(${program} $<TARGET_OBJECTS:${suite}_test_double_objects> ${stubs})
    raysteps_link(${program} f64 raysteps_kit ${ARGN})
    target_link_libraries(${program} PRIVATE raysteps_asking raysteps_kit_main)
    add_test(NAME ${suite}_asked COMMAND ${program})
    set_tests_properties(${suite}_asked PROPERTIES LABELS contract
        ENVIRONMENT RAYSTEPS_WORKER=$<TARGET_FILE:${worker}>)
endfunction()

# raysteps_recognition(<stage>)
#
# A worker of each known mistake and each other right answer; the test that the stage's probes.txt
# recognizes the former and not the latter, and knows the suite's cases; and the target
# <stage>_probes, which writes it.
function(raysteps_recognition stage)
    file(GLOB mistakes CONFIGURE_DEPENDS mistakes/${stage}/*.cpp)
    file(GLOB alternatives CONFIGURE_DEPENDS alternatives/${stage}/*.cpp)
    set(folder ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage})
    set(reports ${CMAKE_CURRENT_BINARY_DIR}/${stage}_reports)
    set(words)
    set(runs)
    foreach(file IN LISTS alternatives)
        get_filename_component(name ${file} NAME_WE)
        raysteps_worker(${stage}_${name}_worker alternatives f64 ${stage}_${name} ${stage}_context)
        list(APPEND words $<TARGET_FILE:${stage}_${name}_worker>)
    endforeach()
    foreach(file IN LISTS mistakes)
        get_filename_component(name ${file} NAME_WE)
        raysteps_worker(${stage}_${name}_worker mistakes f64 ${stage}_${name} ${stage}_context)
        list(APPEND words ${name}=$<TARGET_FILE:${stage}_${name}_worker>)
        list(APPEND runs COMMAND ${CMAKE_COMMAND} -E env RAYSTEPS_REPORT=${reports}/${name}.report
            sh -c "\"$0\" --out /dev/null || true"
            $<TARGET_FILE:mistake_${stage}_${name}_double>)
    endforeach()
    set(reference $<TARGET_FILE:${stage}_reference_worker>)

    set(suite $<TARGET_FILE:${stage}_test_double>)
    set(check $<TARGET_FILE:check_probes> ${folder}/probes.txt ${folder} ${reference} ${words})
    set(names "--list-test-names-only")
    if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
        set(names "--list-tests --verbosity quiet")
    endif()
    add_test(NAME recognition_${stage}
        COMMAND sh -c "suite=$1; shift; \"$suite\" ${names} | \"$@\"" sh ${suite} ${check})
    set_tests_properties(recognition_${stage} PROPERTIES LABELS "mistakes")

    string(REGEX REPLACE "^step0?([0-9]+)_.*" "\\1" number ${stage})
    add_custom_target(${stage}_probes
        COMMAND ${CMAKE_COMMAND} -E make_directory ${reports}
        COMMAND ${CMAKE_COMMAND} -E env RAYSTEPS_RECORD=${reports}/record
            RAYSTEPS_REPORT=${reports}/reference.report RAYSTEPS_WORKER=${reference}
            $<TARGET_FILE:${stage}_asked_test_double>
        ${runs}
        COMMAND choose_probes ${number} ${reports} ${reference} ${folder} ${words}
            > ${folder}/probes.txt
        VERBATIM)
endfunction()
