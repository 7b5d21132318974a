# In a hand-out, sources that contain a solution are replaced by an archive of their objects.
# raysteps_archive(<name> <folder> <source>...): x86_64/f32.a and f64.a, or those of another kind of
# processor, for this folder of a hand-out: the sources compiled again, for all processors of the kind. The
# target `archives` builds them all, in the folder archives/ of the build.
add_custom_target(archives)
function(raysteps_archive name folder)
    foreach(precision IN ITEMS f32 f64)
        set(archive ${name}_archive_${precision})
        raysteps_target(${archive} STATIC ON_DEMAND SOURCES ${ARGN})
        set_target_properties(${archive} PROPERTIES RAYSTEPS_ANY_PROCESSOR ON
            ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/archives/${folder}/${CMAKE_SYSTEM_PROCESSOR}
            PREFIX "" OUTPUT_NAME ${precision} SUFFIX .a)
        if(CMAKE_STRIP)
            add_custom_command(TARGET ${archive} POST_BUILD COMMAND ${CMAKE_STRIP}
                $<IF:$<BOOL:${APPLE}>,-x,--strip-unneeded> $<TARGET_FILE:${archive}> VERBATIM)
        endif()
        add_dependencies(archives ${archive})
    endforeach()
endfunction()

# raysteps_link_archive(<name> <folder> [WHOLE]): a target that links <name>_f32 or _f64 gets the
# contents of the folder's archives: the missing symbols, or with WHOLE all objects.
function(raysteps_link_archive name folder)
    raysteps_require_fit()
    foreach(precision IN ITEMS f32 f64)
        set(file ${PROJECT_SOURCE_DIR}/${folder}/${CMAKE_SYSTEM_PROCESSOR}/${precision}.a)
        if(NOT EXISTS ${file})
            message(FATAL_ERROR "${file} is missing: get the hand-out again")
        endif()
        set(archive ${name}_archive_${precision})
        add_library(${archive} STATIC IMPORTED GLOBAL)
        set_target_properties(${archive} PROPERTIES IMPORTED_LOCATION ${file})
        target_link_libraries(${archive} INTERFACE raysteps_base)
        if("WHOLE" IN_LIST ARGN AND CMAKE_VERSION VERSION_LESS 3.24)
            set(archive -Wl,--whole-archive,${file},--no-whole-archive)
            set_property(TARGET ${name}_${precision} APPEND PROPERTY INTERFACE_LINK_DEPENDS ${file})
        elseif("WHOLE" IN_LIST ARGN)
            set(archive $<LINK_LIBRARY:WHOLE_ARCHIVE,${archive}>)
        endif()
        target_link_libraries(${name}_${precision} INTERFACE ${archive})
    endforeach()
endfunction()

# Reports an error, once, if the archives do not fit this compiler, before a linker would.
function(raysteps_require_fit)
    get_property(fits GLOBAL PROPERTY RAYSTEPS_FITS)
    set(needs ${PROJECT_SOURCE_DIR}/steps/fits.cpp)
    if(fits)
        return()
    elseif(NOT EXISTS ${needs})
        message(FATAL_ERROR "Sources are missing, and this is not a hand-out")
    endif()
    unset(RAYSTEPS_FITS CACHE)  # an update may have replaced the archives
    try_compile(RAYSTEPS_FITS ${PROJECT_BINARY_DIR}/fits ${needs})
    if(NOT RAYSTEPS_FITS)
        file(STRINGS ${needs} kind LIMIT_COUNT 1)
        string(REPLACE "// " "" kind "${kind}")
        message(FATAL_ERROR "This hand-out is for ${kind}, and not for ${CMAKE_CXX_COMPILER_ID} "
            "${CMAKE_CXX_COMPILER_VERSION}, as it is called here, on ${CMAKE_SYSTEM_NAME} with "
            "${CMAKE_SYSTEM_PROCESSOR}: use such a machine and compiler, or request a hand-out for yours.")
    endif()
    set_property(GLOBAL PROPERTY RAYSTEPS_FITS ON)
endfunction()
