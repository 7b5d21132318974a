include(${CMAKE_CURRENT_LIST_DIR}/archives.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/exact.cmake)

# raysteps_stage([<flag>...] [LOOPS_OVER <stage>] [SUITE <part>...] [PICTURES <scene>...]): defines the
# targets of the stage in the current folder.
#
# MESHES             this stage and later ones need OpenMesh
# SHARES_ANEW        its files replace those that earlier stages share with later ones
# WITHOUT_SHAPES     its program has no shapes to hit: no hierarchy, and no settings to choose
# OWN_LOOP           its main.cpp has a loop over the shapes, and calls no query
# WHOLE_KERNEL       its certified kernel includes the rest of the reference
# SANITIZED_IN_BOTH  sanitizers can find more in float: a Real chooses an element, or a number of lanes
# LOOPS_OVER         a kind of shape of which this stage's shape consists
# SUITE              the parts of its suite, tests/suites/<stage>/<part>_test.cpp, in the order of their
#                    cases; by default it is one file, tests/suites/<stage>_test.cpp
# PICTURES           scenes besides its own of which its suite compares the picture
#
# docs/reference/building.md lists its programs. Their parts, each in f32, too:
#
# stepNN_name_reference_f64  objects of reference/*.cpp, or a hand-out's archive
# stepNN_name_student_f64    objects of student/*.cpp, if there are any
# stepNN_name_f64            the selected one of these two, by option
# stepNN_name_certified_f64  objects of exact/*.cpp if there are any, or else the reference
# stepNN_name_picture_f64    the stage's picture: the loop over the pixels, main.cpp, and the files that this
#                            stage and earlier ones share with later ones: the others beside a main.cpp,
#                            except story.cpp; and meshes or their refusal
# stepNN_name_chosen_picture_f64        the same with student/main.cpp, if there is one, by the same option
# stepNN_name_picture_without_main_f64  the same without either
# stepNN_name_unity_f64      the picture and the references, compiled as unity builds: one for each kind of
#                            shape, and one for the rest
function(raysteps_stage)
    set(flags MESHES SHARES_ANEW WITHOUT_SHAPES OWN_LOOP WHOLE_KERNEL SANITIZED_IN_BOTH)
    cmake_parse_arguments(PARSE_ARGV 0 stage "${flags}" "LOOPS_OVER" "SUITE;PICTURES")
    get_filename_component(name ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    foreach(flag IN LISTS flags)  # RAYSTEPS_MESHES are the stages with MESHES
        if(stage_${flag})
            set_property(GLOBAL APPEND PROPERTY RAYSTEPS_${flag} ${name})
        endif()
    endforeach()
    set_property(GLOBAL APPEND PROPERTY RAYSTEPS_STAGES ${name})
    set_property(GLOBAL PROPERTY RAYSTEPS_SUITE_${name} ${stage_SUITE})
    set_property(GLOBAL PROPERTY RAYSTEPS_PICTURES_${name} ${stage_PICTURES})
    string(REGEX REPLACE "^step0?([0-9]+)_.*" "\\1" number ${name})
    set(start_from_common HEADERS raysteps_common_@)

    file(GLOB reference reference/*.cpp)
    if(reference)
        raysteps_compile_twice(${name}_reference ${reference})
        raysteps_archive(${name}_reference steps/${name}/reference ${reference})
    else()
        raysteps_collect(${name}_reference)
        raysteps_link_archive(${name}_reference steps/${name}/reference WHOLE)
    endif()
    raysteps_compile_twice(${name}_main main.cpp ${start_from_common})

    # The student's files, and which of them are chosen.
    file(GLOB student_main student/main.cpp)
    file(GLOB student student/*.cpp)
    list(REMOVE_ITEM student "" ${student_main})
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        raysteps_headers_of(${name} headers)
        set(student_starts_from HEADERS ${headers}_@)
        set(student_main_starts_from ${start_from_common})
    endif()
    set(chosen reference)
    set(chosen_main main)
    if(student)
        raysteps_compile_twice(${name}_student ${student} ${student_starts_from}
            OPTIONS ${students_errors} DEFINITIONS ${students_assertions})
        set(chosen student)
    endif()
    if(student_main)
        raysteps_compile_twice(${name}_student_main ${student_main} ${student_main_starts_from}
            OPTIONS ${students_errors})
        set(chosen_main student_main)
    endif()
    if(RAYSTEPS_REFERENCE STREQUAL "all" OR number IN_LIST RAYSTEPS_REFERENCE)
        set(chosen reference)
        set(chosen_main main)
    endif()
    raysteps_collect(${name} ${name}_${chosen})

    file(GLOB exact exact/*.cpp)
    list(REMOVE_ITEM exact "${RAYSTEPS_EXACT_MESH_BVH}")
    if(exact)
        raysteps_exact(${name}_certified ${exact})
        raysteps_exact(${name}_exact_queries queries.cpp)
        if(NOT stage_WHOLE_KERNEL)  # the reference, whose `intersect` gets another name
            raysteps_exact(${name}_exact_rest ${reference} DEFINITIONS intersect=reference_intersect)
            target_sources(${name}_certified_f64 INTERFACE $<TARGET_OBJECTS:${name}_exact_rest_f64>)
        endif()
    else()
        add_library(${name}_certified_f64 ALIAS ${name}_reference_f64)
    endif()

    file(GLOB shared *.cpp)
    list(FILTER shared EXCLUDE REGEX "/(main|story)\\.cpp$")
    if(stage_SHARES_ANEW)
        set_property(GLOBAL PROPERTY RAYSTEPS_SHARED)
    endif()
    if(shared)
        raysteps_compile_twice(${name}_shared ${shared} ${start_from_common})
        set_property(GLOBAL APPEND PROPERTY RAYSTEPS_SHARED ${name}_shared)
    endif()

    set(meshes raysteps_without_meshes)
    get_property(with_meshes GLOBAL PROPERTY RAYSTEPS_MESHES)
    if(with_meshes)
        if(NOT TARGET raysteps_mesh_file)
            message(STATUS "No ${name}, and no picture of a mesh: libopenmesh-dev provides OpenMesh")
            return()
        endif()
        set(meshes raysteps_meshes)
    endif()
    get_property(parts GLOBAL PROPERTY RAYSTEPS_SHARED)
    list(APPEND parts raysteps_render)
    raysteps_collect(${name}_picture_without_main ${parts} ${meshes})
    raysteps_collect(${name}_picture ${name}_main ${name}_picture_without_main)
    raysteps_collect(${name}_chosen_picture ${name}_${chosen_main} ${name}_picture_without_main)

    get_property(stages GLOBAL PROPERTY RAYSTEPS_STAGES)
    get_property(always GLOBAL PROPERTY RAYSTEPS_IN_EVERY_PROGRAM)
    list(APPEND stages ${always})
    list(REMOVE_DUPLICATES stages)
    set_property(GLOBAL PROPERTY RAYSTEPS_STAGES_OF_${name} ${stages})
    raysteps_target(${name}_number OBJECT APART SOURCES ${PROJECT_SOURCE_DIR}/common/program/stage_number.cpp
        DEFINITIONS RAYSTEPS_STAGE=${number})
    if(RAYSTEPS_EXACT_MESH_BVH)
        raysteps_exact_program(${name} ${meshes} "${parts}" ${stages})
    endif()
    list(TRANSFORM stages APPEND _reference OUTPUT_VARIABLE references)
    if(reference AND NOT RAYSTEPS_SANITIZE)
        raysteps_unity(${name} ${meshes} ${parts} ${references})
    endif()
    set(others ${references})
    list(REMOVE_ITEM others ${name}_reference)
    raysteps_program(${name} ${name} ${name}_chosen_picture ${stages})
    raysteps_program(${name}_reference_program ${name} ${name}_picture ${references})
    raysteps_program(${name}_checked ${name} ${name}_chosen_picture ${name} ${others})
    if(student_main)
        raysteps_compile_twice(${name}_logging_main ${student_main} ON_DEMAND
            DEFINITIONS intersect=logged_intersect)
        raysteps_collect(${name}_logging_picture ${name}_logging_main ${name}_picture_without_main)
        raysteps_program(${name}_logging ${name} ${name}_logging_picture ${name} ${others})
    endif()
endfunction()

# raysteps_headers_of(<stage> <variable>): the precompiled headers from which a student's file of the
# stage starts.
function(raysteps_headers_of stage variable)
    string(REGEX REPLACE "^step[0-9]+_(.*)" "\\1.hpp" contract ${stage})
    file(STRINGS ${PROJECT_SOURCE_DIR}/steps/${stage}/${contract} optional REGEX "^#include <optional>")
    set(${variable} raysteps_rays PARENT_SCOPE)
    if(optional)  # as every shape's header includes
        set(${variable} raysteps_shapes PARENT_SCOPE)
    endif()
endfunction()

# raysteps_program(<program> <stage> <picture> <stage or _reference>...): a program in both precisions.
function(raysteps_program program stage)
    raysteps_target(${program} APART
        SOURCES $<TARGET_OBJECTS:raysteps_program> $<TARGET_OBJECTS:${stage}_number>)
    set(parts ${ARGN})
    if(TARGET ${stage}_unity_f64 AND NOT RAYSTEPS_STUDENT_FILES)
        set(parts ${stage}_unity)
    endif()
    raysteps_both(raysteps_link ${program} @ ${parts} raysteps_common)
    raysteps_link_for(${program} ${stage})
    if(NOT program STREQUAL stage)
        set_target_properties(${program} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
endfunction()

# raysteps_link_for(<program> <stage>): links what stands in for hierarchies and choices if the stage is
# WITHOUT_SHAPES.
function(raysteps_link_for program stage)
    get_property(without_shapes GLOBAL PROPERTY RAYSTEPS_WITHOUT_SHAPES)
    if(stage IN_LIST without_shapes)
        set_target_properties(${program} PROPERTIES RAYSTEPS_WITHOUT_SHAPES ON)
        raysteps_both(raysteps_link ${program} @ raysteps_without_shapes)
    endif()
endfunction()

# raysteps_unity(<stage> <meshes> <part>...): defines <stage>_unity_f32 and _f64: the stage's picture, with
# its main.cpp and these parts, so that calls between them are inlined: this saves up to a fifth of a
# picture's time (docs/reference/speed.md), mainly since g++ assembles a returned std::optional<Real> in
# memory, stores one byte of it and loads eight, which stalls. With a student's file, programs are linked
# from separate parts instead, so that a change compiles only one.
# The parts of a stage that has queries.cpp are compiled as one for the programs of all later stages:
# <stage>_queries_unity. In it, a query inlines the `intersect` that it calls, with the parts of the
# stage that the shape LOOPS_OVER. All other parts are compiled as one for each program.
function(raysteps_unity stage meshes)
    get_property(kinds GLOBAL PROPERTY RAYSTEPS_QUERIES)
    get_property(compiled GLOBAL PROPERTY RAYSTEPS_COMPILED_WITH_QUERIES)
    if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/queries.cpp)
        set(parts)
        foreach(each IN ITEMS ${stage} ${stage_LOOPS_OVER})
            list(APPEND parts ${each}_shared ${each}_reference)
        endforeach()
        raysteps_compile_as_one(${stage}_queries_unity ${parts})
        list(REMOVE_ITEM kinds "${stage_LOOPS_OVER}")
        set_property(GLOBAL PROPERTY RAYSTEPS_QUERIES ${kinds} ${stage})
        set_property(GLOBAL PROPERTY RAYSTEPS_COMPILED_WITH_QUERIES ${compiled} ${parts})
        list(APPEND kinds ${stage})
        list(APPEND compiled ${parts})
    endif()
    list(REMOVE_ITEM ARGN "" ${compiled})
    list(TRANSFORM kinds APPEND _queries_unity)
    raysteps_compile_as_one(${stage}_unity_objects ${stage}_main ${ARGN})
    raysteps_collect(${stage}_unity ${stage}_unity_objects ${kinds} ${meshes})
endfunction()

# raysteps_compile_as_one(<name> <part>...): <name>_f32 and _f64, the sources of all parts compiled as one.
function(raysteps_compile_as_one name)
    list(TRANSFORM ARGN REPLACE "(.+)" "$<TARGET_PROPERTY:\\1_f64,SOURCES>" OUTPUT_VARIABLE sources)
    raysteps_both(raysteps_target ${name}_@ OBJECT SOURCES ${sources} HEADERS raysteps_common_@)
endfunction()
