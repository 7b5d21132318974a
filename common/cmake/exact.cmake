# `--precision exact`: the certified kernels in steps/stepNN/exact/ replace the references of stages
# 3 to 8, and the closest-hit query calls their exact arithmetic where rounded t are too close to
# compare (docs/reference/stability.md). The kernels have the same function names and types as the double
# references. Therefore they are in a separate program, stepNN_name_exact, which shares all other
# objects with stepNN_name and is built only on demand.

# raysteps_exact(<name> <source>...): defines the object library <name>_f64 of certified kernels, or
# of code that calls them.
function(raysteps_exact name)
    add_library(${name}_f64 OBJECT EXCLUDE_FROM_ALL ${ARGN})
    target_link_libraries(${name}_f64 PUBLIC raysteps_options)
    target_compile_definitions(${name}_f64 PRIVATE RT_EXACT)
endfunction()

# raysteps_common_f64 with packed meshes of certified triangles.
file(GLOB RAYSTEPS_EXACT_MESH_BVH CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/steps/*/exact/mesh_bvh.cpp)
if(RAYSTEPS_EXACT_MESH_BVH)  # a hand-out has no kernels
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

# raysteps_exact_program(<stage> <number> <meshes> <stage of the program>...): defines the program
# stepNN_name_exact and the library stepNN_name_exact_picture_f64: the picture part, with the exact
# closest-hit query in main.cpp and in all files queries.cpp.
function(raysteps_exact_program name number meshes)
    raysteps_exact(${name}_exact_main ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
    get_property(handed_on GLOBAL PROPERTY RAYSTEPS_SHARED_LIBRARIES)
    set(objects)
    foreach(part IN LISTS handed_on ITEMS raysteps_render)
        list(APPEND objects $<FILTER:$<TARGET_OBJECTS:${part}_f64>,EXCLUDE,/queries\\.cpp>)
    endforeach()
    list(APPEND objects $<TARGET_OBJECTS:${name}_exact_main_f64>)
    foreach(stage IN LISTS ARGN)
        if(TARGET ${stage}_exact_queries_f64)
            list(APPEND objects $<TARGET_OBJECTS:${stage}_exact_queries_f64>)
        endif()
    endforeach()
    set(picture ${name}_exact_picture_f64)
    add_library(${picture} INTERFACE)
    set(common raysteps_common)
    if(NOT meshes STREQUAL "raysteps_meshes")
        list(APPEND objects $<TARGET_OBJECTS:${meshes}_f64>)
    else()
        set(common raysteps_exact_common)
        if(NOT TARGET raysteps_exact_meshes_f64)
            raysteps_exact(raysteps_exact_meshes ${PROJECT_SOURCE_DIR}/common/program/load_meshes.cpp)
        endif()
        list(APPEND objects $<FILTER:$<TARGET_OBJECTS:raysteps_meshes_f64>,EXCLUDE,/load_meshes\\.cpp>
            $<TARGET_OBJECTS:raysteps_exact_meshes_f64>)
        target_link_libraries(${picture} INTERFACE raysteps_mesh_file)
    endif()
    target_sources(${picture} INTERFACE ${objects})

    list(TRANSFORM ARGN APPEND _certified)
    raysteps_target(${name}_exact ON_DEMAND
        SOURCES $<TARGET_OBJECTS:raysteps_exact_program_f64> ${PROJECT_SOURCE_DIR}/common/program/stage_number.cpp
        DEFINITIONS RAYSTEPS_STAGE=${number})
    raysteps_link(${name}_exact f64 ${ARGN} ${common} ${name}_exact_picture)
endfunction()
