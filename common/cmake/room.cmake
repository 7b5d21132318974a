# raysteps_room([NEUTRAL <source>...] [PRECISIONS <source>...] [MESHES <source>...]
#               [ELSEWHERE <source>...])
#
# The sources of the room in whose folder it is called: what has no Real in it becomes a part of
# raysteps_base; what has is compiled once a precision, for raysteps_common_f32 and _f64, or, if
# only stage 13 needs it, for raysteps_meshes. Other targets compile what is ELSEWHERE. The global
# properties RAYSTEPS_<room>_NEUTRAL and _PRECISIONS list the first two.
function(raysteps_room)
    cmake_parse_arguments(PARSE_ARGV 0 room "" "" "NEUTRAL;PRECISIONS;MESHES;ELSEWHERE")
    file(GLOB unnamed CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.cpp)
    list(REMOVE_ITEM unnamed
        ${room_NEUTRAL} ${room_PRECISIONS} ${room_MESHES} ${room_ELSEWHERE})
    if(unnamed)
        message(FATAL_ERROR "${CMAKE_CURRENT_SOURCE_DIR}/CMakeLists.txt does not name ${unnamed}")
    endif()
    get_filename_component(name ${CMAKE_CURRENT_SOURCE_DIR} NAME)
    foreach(kind IN ITEMS NEUTRAL PRECISIONS MESHES)
        list(TRANSFORM room_${kind} PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/)
        set_property(GLOBAL PROPERTY RAYSTEPS_${name}_${kind} ${room_${kind}})
    endforeach()
    target_sources(raysteps_base PRIVATE ${room_NEUTRAL})
    foreach(precision IN ITEMS f32 f64)
        target_sources(raysteps_common_${precision} PRIVATE ${room_PRECISIONS})
        if(TARGET raysteps_meshes_${precision})
            target_sources(raysteps_meshes_${precision} PRIVATE ${room_MESHES})
        endif()
    endforeach()
endfunction()
