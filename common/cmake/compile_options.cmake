# Compiler options and required packages for all targets, and what targets of both precisions need.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_CXX_FLAGS_RELEASE -O2)  # without NDEBUG: asserts stay active
if(RAYSTEPS_SANITIZE)
    set(CMAKE_CXX_FLAGS_RELEASE -O1)  # the suites compile in a third of the time
endif()

# find_package whose error message names the Debian package to install.
macro(raysteps_find package debian)
    find_package(${package} QUIET)
    if(NOT ${package}_FOUND)
        message(FATAL_ERROR "${package} is missing: apt-get install ${debian}")
    endif()
endmacro()
raysteps_find(glm libglm-dev)
raysteps_find(PNG libpng-dev)
raysteps_find(CLI11 libcli11-dev)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)
# Only stage 13 needs OpenMesh. `./course` unpacks it where it is not installed. Its targets, with the
# place of its headers, are known in the folder of this call and below.
find_package(OpenMesh QUIET PATHS ${PROJECT_BINARY_DIR}/openmesh/usr)

add_library(raysteps_options INTERFACE)
target_include_directories(raysteps_options INTERFACE ${PROJECT_SOURCE_DIR})
target_link_libraries(raysteps_options INTERFACE glm::glm Threads::Threads)
# Default-constructed glm vectors are zero; GLM's own default leaves them uninitialized.
target_compile_definitions(raysteps_options INTERFACE GLM_FORCE_CTOR_INIT)

# Use instructions of the processor at hand: std::fma as an instruction instead of a call that takes ten
# times as long, and vectors of 32 bytes (simd.hpp). The results have the same bits, so objects of both
# kinds can be linked together. A target for other machines has the property RAYSTEPS_ANY_PROCESSOR.
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

target_compile_options(raysteps_options INTERFACE
    # compensated.hpp and the watertight triangle are correct only if each operation is rounded
    # once. `errno` is never read after math functions, so `sqrt` can be one instruction.
    -ffp-contract=off -fno-math-errno
    # Two numbers that are stored separately and loaded as a pair cause a stall: g++ 12 generates
    # that for every Vec3 at -O2. Without it the results have the same bits, up to a fifth faster.
    $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wold-style-cast
    # Reports a helper outside an anonymous namespace, which both precisions would define:
    $<IF:$<CXX_COMPILER_ID:GNU>,-Wmissing-declarations,-Wmissing-prototypes>
    # Caused by macros of GLM or Catch2, or by an aggregate left short on purpose:
    -Wno-missing-field-initializers
    # g++ 11 reports this one without reason in the standard library's headers.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,12>>:-Wno-stringop-overread>)

# For students' files, in `check` as in grading: a missing return is an error. In files of functions,
# an index out of range and an empty optional end the program with a message, in libstdc++ and libc++;
# a main.cpp, whose precompiled header is that of the project, has this with sanitizers only.
set(students_errors -Werror=return-type)
set(students_assertions _GLIBCXX_ASSERTIONS
    _LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_EXTENSIVE)

if(RAYSTEPS_SANITIZE)
    target_compile_options(raysteps_options INTERFACE
        -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)  # as above, with sanitizers in g++ 12
    target_link_options(raysteps_options INTERFACE -fsanitize=address,undefined)
endif()

# The fast linker mold, if it is installed and the compiler can use it: g++ from version 12 on.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=mold RAYSTEPS_MOLD)
if(RAYSTEPS_MOLD)
    target_link_options(raysteps_options INTERFACE -fuse-ld=mold)
endif()

# Targets that exist in both precisions end in f32 and f64, and programs that people start in float and
# double. raysteps_both(<command> <argument>...): calls the command once a precision, with f32 or f64 for
# each @ in its arguments, and float or double for each @word.
set(word_f32 float)
set(word_f64 double)
function(raysteps_both command)
    foreach(precision IN ITEMS f32 f64)
        string(REPLACE "@word" "${word_${precision}}" arguments "${ARGN}")
        string(REPLACE "@" "${precision}" arguments "${arguments}")
        cmake_language(CALL ${command} ${arguments})
    endforeach()
endfunction()

# raysteps_target(<name> [OBJECT | STATIC] [ON_DEMAND] [APART] SOURCES <source>... [EXCEPT <stem>...]
#     [FOLDERS <folder[|folder]>...] [LIBRARIES <library>...] [PARTS <part>...] [OPTIONS <option>...]
#     [DEFINITIONS <definition>...] [HEADERS <header>... | <target>] [NEEDS <target>...]): a program or
# library. With _f32 or _float in its name, its Real is float.
#
# SOURCES    files, or patterns of files, without those EXCEPT. They are compiled as one (CMake's unity
#            build), so that the headers that they share are read once: a first build takes half the time.
#            Those in FOLDERS are compiled as one for each word, so that a program can be linked without
#            what they call; with APART, and with -DCMAKE_UNITY_BUILD=OFF, each file is compiled alone. Two
#            sources that are compiled as one cannot give a helper the same name.
# PARTS      are linked: <part>_f32 or <part>_f64 of each
# HEADERS    precompiled headers from which it starts, or the target that has them
# ON_DEMAND  it is built by name only
function(raysteps_target name)
    cmake_parse_arguments(PARSE_ARGV 1 the "OBJECT;STATIC;ON_DEMAND;APART" ""
        "SOURCES;HEADERS;EXCEPT;FOLDERS;LIBRARIES;PARTS;OPTIONS;DEFINITIONS;NEEDS")
    set(patterns ${the_SOURCES})
    list(FILTER patterns INCLUDE REGEX "[*]")
    list(FILTER the_SOURCES EXCLUDE REGEX "[*]")
    if(patterns)
        file(GLOB found ${patterns})
        list(JOIN the_EXCEPT "|" except)
        list(FILTER found EXCLUDE REGEX "/(${except})\\.cpp$")
        list(APPEND the_SOURCES ${found})
    endif()
    set(scope PUBLIC)
    if(the_OBJECT)
        add_library(${name} OBJECT ${the_SOURCES})
    elseif(the_STATIC)
        add_library(${name} STATIC ${the_SOURCES})
    else()
        add_executable(${name} ${the_SOURCES})
        set(scope PRIVATE)
    endif()
    set(precision f64)
    if(name MATCHES "_(f32|float)(_|$)")
        set(precision f32)
        list(APPEND the_DEFINITIONS RT_FLOAT)
    endif()
    raysteps_link(${name} ${precision} ${the_PARTS})
    target_link_libraries(${name} ${scope} raysteps_options ${the_LIBRARIES})
    target_compile_options(${name} PRIVATE ${the_OPTIONS})
    target_compile_definitions(${name} PRIVATE ${the_DEFINITIONS})
    if(the_HEADERS MATCHES "\\.hpp$")
        target_precompile_headers(${name} PRIVATE ${the_HEADERS})
    elseif(the_HEADERS)
        target_precompile_headers(${name} REUSE_FROM ${the_HEADERS})
    endif()
    if(the_NEEDS)
        add_dependencies(${name} ${the_NEEDS})
    endif()
    if(the_ON_DEMAND)
        set_target_properties(${name} PROPERTIES EXCLUDE_FROM_ALL ON)
    endif()
    if(NOT the_APART AND NOT DEFINED CMAKE_UNITY_BUILD)
        set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
    endif()
    if(the_FOLDERS)
        set_target_properties(${name} PROPERTIES UNITY_BUILD_MODE GROUP)
        set_property(SOURCE ${the_SOURCES} TARGET_DIRECTORY ${name} PROPERTY UNITY_GROUP rest)
    endif()
    foreach(folders IN LISTS the_FOLDERS)
        set(sources ${the_SOURCES})
        list(FILTER sources INCLUDE REGEX "(^|/)(${folders})/[^/]*$")
        string(MAKE_C_IDENTIFIER ${folders} group)
        set_property(SOURCE ${sources} TARGET_DIRECTORY ${name} PROPERTY UNITY_GROUP ${group})
    endforeach()
endfunction()

# raysteps_compile_twice(<name> <source>... [<option of raysteps_target>...]): two object libraries of the
# same sources, <name>_f32, with Real = float, and <name>_f64.
function(raysteps_compile_twice name)
    raysteps_both(raysteps_target ${name}_@ OBJECT APART SOURCES ${ARGN})
endfunction()

# raysteps_link(<target> <precision> <name>...): links a target to <name>_f32 or _f64 of each name.
function(raysteps_link target precision)
    list(TRANSFORM ARGN APPEND _${precision})
    target_link_libraries(${target} PRIVATE ${ARGN})
endfunction()

# raysteps_collect(<collection> <name>...): defines <collection>_f32 and _f64; who links it, links
# all of these, and their objects.
function(raysteps_collect collection)
    raysteps_both(add_library ${collection}_@ INTERFACE)
    foreach(name IN LISTS ARGN)
        raysteps_both(target_link_libraries ${collection}_@ INTERFACE ${name}_@)
        get_target_property(type ${name}_f64 TYPE)
        if(type STREQUAL "OBJECT_LIBRARY")  # whose objects only a direct link contains
            raysteps_both(target_sources ${collection}_@ INTERFACE $<TARGET_OBJECTS:${name}_@>)
        endif()
    endforeach()
endfunction()
