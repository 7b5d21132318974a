# The suites whose questions a worker answers, as in a graded run. A hand-out has none of them.

# raysteps_asked_suite(<suite> <worker> <part>...): <suite>_asked_test_double and its test with this
# worker, linked to the suite's stubs, if there are any, and to these parts.
function(raysteps_asked_suite suite worker)
    raysteps_target(${suite}_asked_test_double APART
        SOURCES $<TARGET_OBJECTS:${suite}_test_double_objects> contract/stubs/${suite}.c*
        PARTS raysteps_kit ${ARGN} LIBRARIES raysteps_asking raysteps_kit_main
        OPTIONS ${quickly} HEADERS raysteps_kit_f64)
    raysteps_add_test(${suite}_asked contract
        "ENVIRONMENT;RAYSTEPS_WORKER=$<TARGET_FILE:${worker}>" ${suite}_asked_test_double)
endfunction()

# raysteps_recognition(<stage>): a worker of all known mistakes and other right answers; the test that
# the stage's probes.txt recognizes the former and not the latter, and knows the suite's cases; and
# the target <stage>_probes, which writes it.
function(raysteps_recognition stage)
    raysteps_worker(${stage}_answers_worker "" ${stage}_answers ${stage}_context)
    set(mistakes ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage})
    set(words ${PROJECT_SOURCE_DIR} ${stage}
        $<TARGET_FILE:${stage}_reference_worker> $<TARGET_FILE:${stage}_answers_worker>)
    set(names "--list-test-names-only")
    if(Catch2_VERSION VERSION_GREATER_EQUAL 3)
        set(names "--list-tests --verbosity quiet")
    endif()
    raysteps_add_test(recognition_${stage} mistakes ""
        sh -c "suite=$1 && shift && \"$suite\" ${names} | \"$@\"" sh
        $<TARGET_FILE:${stage}_test_double> $<TARGET_FILE:check_probes> ${mistakes}/probes.txt ${words}
        $<TARGET_FILE:${stage}_answers_test_double>)

    set(reports ${CMAKE_CURRENT_BINARY_DIR}/${stage}_reports)
    add_custom_target(${stage}_probes
        COMMAND ${CMAKE_COMMAND} -E make_directory ${reports}
        COMMAND ${CMAKE_COMMAND} -E env RAYSTEPS_RECORD=${reports}/record
            RAYSTEPS_REPORT=${reports}/reference.report
            RAYSTEPS_WORKER=$<TARGET_FILE:${stage}_reference_worker>
            $<TARGET_FILE:${stage}_asked_test_double>
        COMMAND choose_probes ${reports} ${words} $<TARGET_FILE:${stage}_answers_test_double> > ${mistakes}/probes.txt
        VERBATIM)
    if(EXISTS ${mistakes}/trace.txt)
        raysteps_add_test(recognition_${stage}_trace mistakes ""
            sh ${CMAKE_CURRENT_SOURCE_DIR}/trace_mistakes.sh check ${folders} ${stage})
    endif()
endfunction()
