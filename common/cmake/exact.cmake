# `--precision exact`: the certified kernels in steps/stepNN/exact/ replace the references of stages
# 3 to 8, and the closest-hit query calls their exact arithmetic where rounded t are too close to
# compare (docs/reference/stability.md). The kernels have the same function names and types as the double
# references. Therefore they are in a separate program, stepNN_name_exact, which shares all other
# objects with stepNN_name and is built only on demand.

# raysteps_exact(<name> <source>... [<option of raysteps_target>...]): the object library <name>_f64 of
# certified kernels, or of code that calls them.
function(raysteps_exact name)
    raysteps_target(${name}_f64 OBJECT ON_DEMAND APART SOURCES ${ARGN})
    target_compile_definitions(${name}_f64 PRIVATE RT_EXACT)
endfunction()

# Packed meshes of certified triangles, which the linker prefers to those in libraysteps_with_shapes_f64.a.
set(common ${PROJECT_SOURCE_DIR}/common)
file(GLOB RAYSTEPS_EXACT_MESH_BVH ${PROJECT_SOURCE_DIR}/steps/*/exact/mesh_bvh.cpp)
if(RAYSTEPS_EXACT_MESH_BVH)  # a hand-out has no kernels
    raysteps_exact(raysteps_exact_mesh_bvh ${common}/bvh/mesh_bvh.cpp ${RAYSTEPS_EXACT_MESH_BVH})
    raysteps_exact(raysteps_exact_meshes ${common}/program/load_meshes.cpp)
    raysteps_exact(raysteps_exact_program ${common}/program/main.cpp
        DEFINITIONS RAYSTEPS_ROOT="${PROJECT_SOURCE_DIR}")
endif()

# raysteps_exact_program(<stage> <meshes> <shared> <stage of the program>...): defines the program
# stepNN_name_exact and the library stepNN_name_exact_picture_f64: the picture part, with the exact
# closest-hit query in main.cpp and in all files queries.cpp.
function(raysteps_exact_program name meshes shared)
    raysteps_exact(${name}_exact_main ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
    set(exact ${name}_exact_main)
    add_library(${name}_exact_picture_f64 INTERFACE)
    if(meshes STREQUAL "raysteps_meshes")
        list(APPEND exact raysteps_exact_mesh_bvh raysteps_exact_meshes)
        target_link_libraries(${name}_exact_picture_f64 INTERFACE raysteps_mesh_file)
    endif()
    foreach(stage IN LISTS ARGN)
        if(TARGET ${stage}_exact_queries_f64)
            list(APPEND exact ${stage}_exact_queries)
        endif()
    endforeach()
    foreach(part IN LISTS exact)
        target_sources(${name}_exact_picture_f64 INTERFACE $<TARGET_OBJECTS:${part}_f64>)
    endforeach()
    foreach(part IN LISTS shared meshes)
        target_sources(${name}_exact_picture_f64 INTERFACE
            "$<FILTER:$<TARGET_OBJECTS:${part}_f64>,EXCLUDE,/(queries|load_meshes)\\.cpp>")
    endforeach()
    list(TRANSFORM ARGN APPEND _certified)
    raysteps_target(${name}_exact ON_DEMAND
        SOURCES $<TARGET_OBJECTS:raysteps_exact_program_f64> $<TARGET_OBJECTS:${name}_number>
        PARTS ${ARGN} ${name}_exact_picture raysteps_common)
endfunction()
