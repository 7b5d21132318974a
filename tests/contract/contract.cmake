# A stage's contract, called in another process: the workers, and the suites linked to stubs that
# call them. Targets without a precision in the name are in double.

# raysteps_worker(<program> <folder> <precision> <stage>...)
#
# A worker linked to the objects of these stages.
function(raysteps_worker program folder precision)
    add_executable(${program})
    target_link_libraries(${program} PRIVATE
        raysteps_worker_${precision} raysteps_common_${precision} raysteps_base Threads::Threads)
    foreach(stage IN LISTS ARGN)
        target_link_libraries(${program} PRIVATE ${stage}_${precision})
    endforeach()
    set_target_properties(${program} PROPERTIES
        RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
endfunction()

# raysteps_contract(<stage> <other stages>...)
#
# <stage>_worker_float, _double      the chosen one
# <stage>_reference_worker           the reference
# <stage>_asked_test_float, _double  the suite with a worker
function(raysteps_contract stage)
    raysteps_worker(${stage}_reference_worker "" f64 ${stage}_reference ${stage}_picture ${ARGN})
    foreach(precision IN ITEMS f32 f64)
        set(word_f32 float)
        set(word_f64 double)
        set(word ${word_${precision}})
        raysteps_worker(${stage}_worker_${word} "" ${precision} ${stage} ${stage}_picture ${ARGN})

        add_library(${stage}_stubs_${precision} OBJECT contract/stubs/${stage}.cpp)
        target_link_libraries(${stage}_stubs_${precision} PRIVATE raysteps_kit_${precision}_options)
        target_precompile_headers(${stage}_stubs_${precision} REUSE_FROM raysteps_kit_${precision})
        set(program ${stage}_asked_test_${word})
        add_executable(${program} $<TARGET_OBJECTS:${stage}_test_${word}_objects>)
        target_link_libraries(${program} PRIVATE
            ${stage}_stubs_${precision} raysteps_asking_${precision} raysteps_kit_${precision}
            raysteps_kit_main raysteps_common_${precision} raysteps_base Threads::Threads)
        foreach(other IN ITEMS ${stage}_picture ${ARGN})
            target_link_libraries(${program} PRIVATE ${other}_${precision})
        endforeach()
        if(precision STREQUAL "f32")  # tested in one precision only
            set_target_properties(${program} ${stage}_worker_${word} ${stage}_stubs_${precision}
                PROPERTIES EXCLUDE_FROM_ALL ON)
            continue()
        endif()
        add_test(NAME ${stage}_asked COMMAND ${program})
        set_tests_properties(${stage}_asked PROPERTIES LABELS contract
            ENVIRONMENT RAYSTEPS_WORKER=$<TARGET_FILE:${stage}_worker_${word}>)
    endforeach()
endfunction()

# raysteps_recognition(<stage> <mistakes> <alternatives> <other stages>...)
#
# A worker of each known mistake and each other right answer; the test that the stage's probes.txt
# recognizes the former and not the latter, and knows the suite's cases; and the target
# <stage>_probes, which writes it.
function(raysteps_recognition stage mistakes alternatives)
    set(folder ${CMAKE_CURRENT_SOURCE_DIR}/mistakes/${stage})
    set(words)
    foreach(file IN LISTS alternatives)
        get_filename_component(name ${file} NAME_WE)
        raysteps_worker(${stage}_${name}_worker alternatives f64 ${stage}_${name} ${ARGN})
        list(APPEND words $<TARGET_FILE:${stage}_${name}_worker>)
    endforeach()
    foreach(file IN LISTS mistakes)
        get_filename_component(name ${file} NAME_WE)
        raysteps_worker(${stage}_${name}_worker mistakes f64 ${stage}_${name} ${ARGN})
        list(APPEND words ${name}=$<TARGET_FILE:${stage}_${name}_worker>)
    endforeach()
    set(reference $<TARGET_FILE:${stage}_reference_worker>)

    set(suite $<TARGET_FILE:${stage}_test_double>)
    set(check $<TARGET_FILE:check_probes> ${folder}/probes.txt ${folder} ${reference} ${words})
    add_test(NAME recognition_${stage}
        COMMAND sh -c "suite=$1; shift; \"$suite\" --list-test-names-only | \"$@\"" sh ${suite} ${check})
    set_tests_properties(recognition_${stage} PROPERTIES LABELS "mistakes")

    string(REGEX REPLACE "^step0?([0-9]+)_.*" "\\1" number ${stage})
    set(reports ${CMAKE_CURRENT_BINARY_DIR}/${stage}_reports)
    set(runs)
    foreach(file IN LISTS mistakes)
        get_filename_component(name ${file} NAME_WE)
        list(APPEND runs COMMAND ${CMAKE_COMMAND} -E env RAYSTEPS_REPORT=${reports}/${name}.report
            sh -c "\"$0\" --out /dev/null || true"
            $<TARGET_FILE:mistake_${stage}_${name}_double>)
    endforeach()
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
