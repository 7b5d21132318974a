# Compiler options and required packages for all targets.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_FLAGS_RELEASE -O2)  # without NDEBUG: asserts stay active
if(RAYSTEPS_SANITIZE)
    set(CMAKE_CXX_FLAGS_RELEASE -O1)  # the suites compile in a third of the time
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# raysteps_find(<package> <Debian package>)
#
# find_package whose error message names the Debian package to install.
macro(raysteps_find package debian)
    find_package(${package} QUIET ${ARGN})
    if(NOT ${package}_FOUND)
        message(FATAL_ERROR "${package} is missing: apt-get install ${debian}")
    endif()
endmacro()

raysteps_find(glm libglm-dev)
raysteps_find(PNG libpng-dev)
raysteps_find(CLI11 libcli11-dev)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

add_library(raysteps_options INTERFACE)
target_include_directories(raysteps_options INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(raysteps_options INTERFACE glm::glm Threads::Threads)
# Default-constructed glm vectors are zero; GLM's own default leaves them uninitialized.
target_compile_definitions(raysteps_options INTERFACE GLM_FORCE_CTOR_INIT)

# Use instructions of the processor at hand: std::fma as an instruction instead of a call that takes
# ten times as long, and vectors of 32 bytes (simd.hpp). The results have the same bits. A target
# for other machines has the property RAYSTEPS_ANY_PROCESSOR; the option of that name sets it for
# all targets. Objects of both kinds can be linked together, because functions that both define have
# the same effect.
option(RAYSTEPS_ANY_PROCESSOR "Build for all processors of this kind, not only for this one" OFF)
if(NOT RAYSTEPS_ANY_PROCESSOR)
    include(CheckCXXSourceRuns)
    set(CMAKE_REQUIRED_FLAGS "-mfma -mavx2 -mbmi")
    check_cxx_source_runs("int main() {
        return __builtin_cpu_supports(\"fma\") && __builtin_cpu_supports(\"avx2\")
            && __builtin_cpu_supports(\"bmi\") ? 0 : 1; }"
        RAYSTEPS_FMA_AVX2_BMI)
    unset(CMAKE_REQUIRED_FLAGS)
    if(RAYSTEPS_FMA_AVX2_BMI)
        target_compile_options(raysteps_options INTERFACE
            "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:RAYSTEPS_ANY_PROCESSOR>>>:-mfma;-mavx2;-mbmi>")
    endif()
endif()

# compensated.hpp and the watertight triangle are correct only if each operation is rounded
# once. `errno` is never read after math functions, so `sqrt` can be one instruction.
target_compile_options(raysteps_options INTERFACE -ffp-contract=off -fno-math-errno)
# Two numbers that are stored separately and loaded as a pair cause a stall: g++ 12 generates
# that for every Vec3 at -O2. Without it the results have the same bits, up to a fifth faster.
target_compile_options(raysteps_options INTERFACE
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>)
target_compile_options(raysteps_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wold-style-cast
    # Reports a helper outside an anonymous namespace, which both precisions would define:
    $<IF:$<CXX_COMPILER_ID:GNU>,-Wmissing-declarations,-Wmissing-prototypes>
    # Caused by macros of GLM or Catch2, or by an aggregate left short on purpose:
    -Wno-missing-field-initializers
    # g++ 11 reports this one without reason in the standard library's headers.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,12>>:-Wno-stringop-overread>)
if(RAYSTEPS_SANITIZE)
    target_compile_options(raysteps_options INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
        # With sanitizers g++ 12 reports this warning without reason in the standard library's
        # headers.
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    target_link_options(raysteps_options INTERFACE -fsanitize=address,undefined)
endif()

# The fast linker mold, if it is installed and the compiler can use it: g++ from version 12 on.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold RAYSTEPS_MOLD)
if(RAYSTEPS_MOLD)
    target_link_options(raysteps_options INTERFACE -fuse-ld=mold)
endif()

# Targets that exist in both precisions end in f32 and f64, and programs that people start in
# ${word_f32} and ${word_f64}.
set(word_f32 float)
set(word_f64 double)

# raysteps_compile_twice(<name> <source>...)
#
# Defines two object libraries of the same sources: <name>_f32, with Real = float, and <name>_f64.
function(raysteps_compile_twice name)
    foreach(precision IN ITEMS f32 f64)
        add_library(${name}_${precision} OBJECT ${ARGN})
        target_link_libraries(${name}_${precision} PUBLIC raysteps_options)
    endforeach()
    target_compile_definitions(${name}_f32 PRIVATE RT_FLOAT)
endfunction()

# raysteps_compile_by_folder(<target>...)
#
# Compiles each folder's sources as one (CMake's unity build), so that the headers that they share are
# read once: a first build takes half the time. Two sources of a folder cannot give a helper the same
# name. -DCMAKE_UNITY_BUILD=OFF compiles each source alone.
function(raysteps_compile_by_folder)
    if(NOT DEFINED CMAKE_UNITY_BUILD)
        set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON)
    endif()
    foreach(target IN LISTS ARGN)
        set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
        get_target_property(sources ${target} SOURCES)
        get_target_property(base ${target} SOURCE_DIR)
        foreach(source IN LISTS sources)
            cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${base} OUTPUT_VARIABLE folder)
            cmake_path(GET folder PARENT_PATH folder)
            cmake_path(GET folder FILENAME folder)
            set_property(SOURCE ${source} TARGET_DIRECTORY ${target} PROPERTY UNITY_GROUP ${folder})
        endforeach()
    endforeach()
endfunction()

# raysteps_start_from_common(<name>)
#
# Compiles <name>_f32 and <name>_f64 in half the time with the precompiled headers of
# raysteps_common. Not for a student's file or a reference, which must include the headers that they
# use.
function(raysteps_start_from_common name)
    foreach(precision IN ITEMS f32 f64)
        target_precompile_headers(${name}_${precision} REUSE_FROM raysteps_common_${precision})
    endforeach()
endfunction()

# raysteps_compile_without_optimizing(<target> <precision>)
#
# Compiles the target in half the time, with the same precompiled headers. For what runs briefly, such
# as a known mistake. Its numbers have the same bits.
function(raysteps_compile_without_optimizing target precision)
    target_compile_options(${target} PRIVATE -O0)
    target_precompile_headers(${target} REUSE_FROM raysteps_unoptimized_${precision})
endfunction()

# raysteps_precompile(<name> <header>...)
#
# Defines <name>_f32 and _f64, for g++: the headers, precompiled in a folder <name>.hpp.gch beside a
# file <name>.hpp that includes them.
function(raysteps_precompile name)
    list(TRANSFORM ARGN REPLACE "(.+)" "#include \"${PROJECT_SOURCE_DIR}/\\1\"\n")
    string(CONCAT includes ${ARGN})
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.hpp.gch/all.cpp)
    file(CONFIGURE OUTPUT ${source} CONTENT "${includes}")
    raysteps_compile_twice(${name} ${source})
    foreach(target IN ITEMS ${name}_f32 ${name}_f64)
        target_compile_options(${target} PRIVATE "SHELL:-x c++-header")
        set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ON
            RAYSTEPS_HEADER ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/${name}.hpp)
        file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${target}.dir/${name}.hpp
            CONTENT "${includes}")
    endforeach()
endfunction()

# raysteps_start_from(<headers> <name> <source>...)
#
# Compiles <name>_f32 and <name>_f64, of these sources, in a third of the time with g++: they start
# from what <headers>_f32 and _f64 have precompiled.
function(raysteps_start_from headers name)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        foreach(precision IN ITEMS f32 f64)
            get_target_property(header ${headers}_${precision} RAYSTEPS_HEADER)
            set_property(SOURCE ${ARGN} APPEND PROPERTY OBJECT_DEPENDS
                ${header}.gch/all.cpp${CMAKE_CXX_OUTPUT_EXTENSION})
            target_compile_options(${name}_${precision} PRIVATE "SHELL:-include \"${header}\"")
        endforeach()
    endif()
endfunction()

# raysteps_link(<target> <precision> <name>...)
#
# Links a target to <name>_f32 or <name>_f64 of each name.
function(raysteps_link target precision)
    list(TRANSFORM ARGN APPEND _${precision})
    target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()

# raysteps_collect(<collection> <name>...)
#
# Defines <collection>_f32 and _f64: who links it, links all of these, and their objects.
function(raysteps_collect collection)
    foreach(precision IN ITEMS f32 f64)
        add_library(${collection}_${precision} INTERFACE)
        foreach(name IN LISTS ARGN)
            set(part ${name}_${precision})
            target_link_libraries(${collection}_${precision} INTERFACE ${part})
            get_target_property(type ${part} TYPE)
            if(type STREQUAL "OBJECT_LIBRARY")  # whose objects only a direct link contains
                target_sources(${collection}_${precision} INTERFACE $<TARGET_OBJECTS:${part}>)
            endif()
        endforeach()
    endforeach()
endfunction()
