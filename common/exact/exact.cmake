# `--precision exact`: certified kernels, steps/stepNN/exact/, in place of the references of stages 3
# to 8 (docs/stability.md). Theirs are the same functions of the same numbers as the double
# references', so they are a program of their own: stepNN_name_exact, which shares all other objects
# with stepNN_name, and is built when it is first asked for.

# Where the processor multiplies and adds at once, std::fma need not be a call: the same bits sooner.
# They run where they are built.
include(CheckCXXSourceRuns)
set(CMAKE_REQUIRED_FLAGS -mfma)
check_cxx_source_runs("#include <cmath>
    int main(int argc, char**) { return std::fma(double(argc), 1.0, -double(argc)) == 0 ? 0 : 1; }"
    RAYSTEPS_FMA)
unset(CMAKE_REQUIRED_FLAGS)

# raysteps_exact(<name> <source>...)
#
# The object library <name>_f64 of certified kernels, or of what calls them.
function(raysteps_exact name)
    add_library(${name}_f64 OBJECT EXCLUDE_FROM_ALL ${ARGN})
    target_link_libraries(${name}_f64 PUBLIC raysteps_options)
    target_compile_definitions(${name}_f64 PRIVATE RT_EXACT)
    if(RAYSTEPS_FMA)
        target_compile_options(${name}_f64 PRIVATE -mfma)
    endif()
endfunction()

# raysteps_exact_stages(<variable> <stage>...)
#
# The stages' references, or certified kernels where there are some.
function(raysteps_exact_stages variable)
    set(chosen ${ARGN})
    list(TRANSFORM chosen APPEND _reference)
    foreach(stage IN LISTS ARGN)
        if(TARGET ${stage}_exact_f64)
            list(TRANSFORM chosen REPLACE "^${stage}_reference$" ${stage}_exact)
        endif()
    endforeach()
    set(${variable} ${chosen} PARENT_SCOPE)
endfunction()

# raysteps_exact_program(<stage> <number> <stage of the program>...)
function(raysteps_exact_program name number)
    add_executable(${name}_exact EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/common/main.cpp)
    target_compile_definitions(${name}_exact PRIVATE
        RT_EXACT RAYSTEPS_STAGE=${number} RAYSTEPS_ROOT="${PROJECT_SOURCE_DIR}")
    raysteps_exact_stages(parts ${ARGN})
    if(number LESS 13)
        list(APPEND parts raysteps_common)
    else()  # meshes, whose triangles are asked by the kernel
        raysteps_exact(raysteps_exact_packed_mesh ${PROJECT_SOURCE_DIR}/common/packed_mesh.cpp)
        list(APPEND parts raysteps_exact_packed_mesh)
        target_sources(${name}_exact PRIVATE
            $<FILTER:$<TARGET_OBJECTS:raysteps_common_f64>,EXCLUDE,/packed_mesh\\.cpp>)
    endif()
    foreach(part IN LISTS parts ITEMS ${name}_picture)
        target_link_libraries(${name}_exact PRIVATE ${part}_f64)
    endforeach()
    target_link_libraries(${name}_exact PRIVATE raysteps_neutral raysteps_options Threads::Threads)
endfunction()
