# raysteps_room(<room> <kind> [<another kind> <source>...]...): the sources of a room of common/, which
# are of the first kind but for those that are named after another one.
#
# NEUTRAL     has no Real in it: a part of raysteps_base
# PRECISIONS  is compiled once a precision: for raysteps_common_f32 and _f64
# MESHES      the same, but only stage 13 needs it: raysteps_meshes
# ELSEWHERE   other targets compile it
# The global properties RAYSTEPS_<room>_NEUTRAL and _PRECISIONS list the first two.
function(raysteps_room name kind)
    cmake_parse_arguments(PARSE_ARGV 2 room "" "" "NEUTRAL;PRECISIONS;MESHES;ELSEWHERE")
    file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR}/${name} ${name}/*.cpp)
    list(REMOVE_ITEM sources "" ${room_NEUTRAL} ${room_PRECISIONS} ${room_MESHES} ${room_ELSEWHERE})
    list(APPEND room_${kind} ${sources})
    foreach(each IN ITEMS NEUTRAL PRECISIONS MESHES)
        list(TRANSFORM room_${each} PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/${name}/)
        set_property(GLOBAL PROPERTY RAYSTEPS_${name}_${each} ${room_${each}})
    endforeach()
    target_sources(raysteps_base PRIVATE ${room_NEUTRAL})
    raysteps_both(target_sources raysteps_common_@ PRIVATE ${room_PRECISIONS})
    if(TARGET raysteps_meshes_f64)
        raysteps_both(target_sources raysteps_meshes_@ PRIVATE ${room_MESHES})
    endif()
endfunction()
