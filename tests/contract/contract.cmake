# A stage's contract, called in another process: the workers, and the suites linked to stubs that
# call them. Targets without a precision in the name are in double.

# raysteps_worker(<program> <folder> <precision> <name>...): a worker linked to <name>_f32 or _f64 of
# each name.
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
        raysteps_worker(${stage}_worker_${word_${precision}} "" ${precision} ${stage} ${stage}_context)
    endforeach()
    set_target_properties(${stage}_worker_float PROPERTIES EXCLUDE_FROM_ALL ON)
    raysteps_suite_objects(${stage}_stubs f64 contract/stubs/${stage}.cpp)
    raysteps_asked_suite(${stage} ${stage}_worker_double $<TARGET_OBJECTS:${stage}_stubs> ${stage}_context)
endfunction()

# raysteps_asked_suite(<suite> <worker> <stubs> <name>...): <suite>_asked_test_double and its test with
# this worker, linked to the stubs and <name>_f64 of each name.
function(raysteps_asked_suite suite worker stubs)
    set(program ${suite}_asked_test_double)
    add_executable(${program} $<TARGET_OBJECTS:${suite}_test_double_objects> ${stubs})
    raysteps_link(${program} f64 raysteps_kit ${ARGN})
    target_link_libraries(${program} PRIVATE raysteps_asking raysteps_kit_main)
    raysteps_add_test(${suite}_asked contract
        "ENVIRONMENT;RAYSTEPS_WORKER=$<TARGET_FILE:${worker}>" ${program})
endfunction()

# raysteps_recognition(<stage>): a worker of all known mistakes and other right answers; the test that
# the stage's probes.txt recognizes the former and not the latter, and knows the suite's cases; and
# the target <stage>_probes, which writes it.
function(raysteps_recognition stage)
    raysteps_worker(${stage}_answers_worker "" f64 ${stage}_answers ${stage}_context)
    set(probes ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage}/probes.txt)
    set(words ${PROJECT_SOURCE_DIR} ${stage}
        $<TARGET_FILE:${stage}_reference_worker> $<TARGET_FILE:${stage}_answers_worker>)
    set(names "--list-test-names-only")
    if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
        set(names "--list-tests --verbosity quiet")
    endif()
    raysteps_add_test(recognition_${stage} mistakes ""
        sh -c "suite=$1 && shift && \"$suite\" ${names} | \"$@\"" sh
        $<TARGET_FILE:${stage}_test_double> $<TARGET_FILE:check_probes> ${probes} ${words})

    set(reports ${CMAKE_CURRENT_BINARY_DIR}/${stage}_reports)
    add_custom_target(${stage}_probes
        COMMAND ${CMAKE_COMMAND} -E make_directory ${reports}
        COMMAND ${CMAKE_COMMAND} -E env RAYSTEPS_RECORD=${reports}/record
            RAYSTEPS_REPORT=${reports}/reference.report
            RAYSTEPS_WORKER=$<TARGET_FILE:${stage}_reference_worker>
            $<TARGET_FILE:${stage}_asked_test_double>
        COMMAND choose_probes ${reports} ${words} $<TARGET_FILE:${stage}_answers_test_double> > ${probes}
        VERBATIM)
endfunction()
