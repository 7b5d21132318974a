# `--precision exact`: the certified kernels in steps/stepNN/exact/ replace the references of stages
# 3 to 8, and the closest-hit query calls their exact arithmetic where rounded t are too close to
# compare (docs/reference/stability.md). The kernels have the same function names and types as the double
# references. Therefore they are in a separate program, stepNN_name_exact, which shares all other
# objects with stepNN_name and is built only on demand.

# raysteps_exact(<name> <source>...)
#
# Defines the object library <name>_f64 of certified kernels, or of code that calls them.
function(raysteps_exact name)
    add_library(${name}_f64 OBJECT EXCLUDE_FROM_ALL ${ARGN})
    target_link_libraries(${name}_f64 PUBLIC raysteps_options)
    target_compile_definitions(${name}_f64 PRIVATE RT_EXACT)
endfunction()

# raysteps_exact_rest(<stage> <source of the reference>...)
#
# Adds the rest of the stage to the library <stage>_certified_f64 of its kernel: the reference, whose
# `intersect` gets another name.
function(raysteps_exact_rest name)
    raysteps_exact(${name}_exact_rest ${ARGN})
    target_compile_definitions(${name}_exact_rest_f64 PRIVATE intersect=reference_intersect)
    target_sources(${name}_certified_f64 INTERFACE $<TARGET_OBJECTS:${name}_exact_rest_f64>)
endfunction()

# raysteps_common_f64 with packed meshes of certified triangles.
set(RAYSTEPS_EXACT_MESH_BVH ${PROJECT_SOURCE_DIR}/steps/step13_meshes/exact/mesh_bvh.cpp)
if(NOT EXISTS ${PROJECT_SOURCE_DIR}/steps/handout.txt)  # a hand-out has no kernels
    raysteps_exact(raysteps_exact_mesh_bvh
        ${PROJECT_SOURCE_DIR}/common/bvh/mesh_bvh.cpp ${RAYSTEPS_EXACT_MESH_BVH})
    add_library(raysteps_exact_common_f64 INTERFACE)
    target_link_libraries(raysteps_exact_common_f64 INTERFACE raysteps_base)
    target_sources(raysteps_exact_common_f64 INTERFACE
        $<FILTER:$<TARGET_OBJECTS:raysteps_common_f64>,EXCLUDE,/mesh_bvh\\.cpp>
        $<TARGET_OBJECTS:raysteps_exact_mesh_bvh_f64>)
    raysteps_exact(raysteps_exact_program ${PROJECT_SOURCE_DIR}/common/program/main.cpp)
    target_compile_definitions(raysteps_exact_program_f64 PRIVATE RAYSTEPS_ROOT="${PROJECT_SOURCE_DIR}")
endif()

# raysteps_exact_program(<stage> <number> <meshes> <stage of the program>...)
#
# Defines the program stepNN_name_exact and the library stepNN_name_exact_picture_f64: the picture
# part, with the exact closest-hit query in main.cpp and in all files queries.cpp.
function(raysteps_exact_program name number meshes)
    raysteps_exact(${name}_exact_main ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
    set(picture ${name}_exact_picture_f64)
    add_library(${picture} INTERFACE)
    get_property(handed_on GLOBAL PROPERTY RAYSTEPS_SHARED_LIBRARIES)
    foreach(part IN LISTS handed_on ITEMS raysteps_render)
        target_sources(${picture} INTERFACE
            $<FILTER:$<TARGET_OBJECTS:${part}_f64>,EXCLUDE,/queries\\.cpp>)
    endforeach()
    target_sources(${picture} INTERFACE $<TARGET_OBJECTS:${name}_exact_main_f64>)
    foreach(stage IN LISTS ARGN)
        if(TARGET ${stage}_exact_queries_f64)
            target_sources(${picture} INTERFACE $<TARGET_OBJECTS:${stage}_exact_queries_f64>)
        endif()
    endforeach()
    set(common raysteps_common)
    if(NOT meshes STREQUAL "raysteps_meshes")
        target_sources(${picture} INTERFACE $<TARGET_OBJECTS:${meshes}_f64>)
    else()
        set(common raysteps_exact_common)
        raysteps_exact(raysteps_exact_meshes ${PROJECT_SOURCE_DIR}/common/program/load_meshes.cpp)
        target_sources(${picture} INTERFACE
            $<FILTER:$<TARGET_OBJECTS:raysteps_meshes_f64>,EXCLUDE,/load_meshes\\.cpp>
            $<TARGET_OBJECTS:raysteps_exact_meshes_f64>)
        target_link_libraries(${picture} INTERFACE raysteps_mesh_file)
    endif()

    add_executable(${name}_exact EXCLUDE_FROM_ALL
        $<TARGET_OBJECTS:raysteps_exact_program_f64> ${PROJECT_SOURCE_DIR}/common/program/stage_number.cpp)
    target_compile_definitions(${name}_exact PRIVATE RAYSTEPS_STAGE=${number})
    list(TRANSFORM ARGN APPEND _certified)
    raysteps_link(${name}_exact f64 ${ARGN} ${common} ${name}_exact_picture)
endfunction()
