# raysteps_room(<room> <kind> [<another kind> <stem>...]...): the sources of a room of common/, which are
# of the first kind but for those that are named after another one.
#
# NEUTRAL     has no Real in it: a part of raysteps_base
# PRECISIONS  is compiled once a precision: for raysteps_common_f32 and _f64
# CHOICES     is like NEUTRAL, and WITH_SHAPES like PRECISIONS, but the stages before there are shapes do
#             without: raysteps_choices, raysteps_with_shapes_f32 and _f64
# MESHES      is like PRECISIONS, but only stage 13 needs it: raysteps_meshes
# ELSEWHERE   other targets compile it
# The variables of these names list the sources of all rooms, the global properties RAYSTEPS_<room>_NEUTRAL
# and _PRECISIONS those of one.
function(raysteps_room name kind)
    set(kinds NEUTRAL PRECISIONS CHOICES WITH_SHAPES MESHES)
    cmake_parse_arguments(PARSE_ARGV 2 room "" "" "${kinds};ELSEWHERE")
    file(GLOB sources CONFIGURE_DEPENDS ${name}/*.cpp)
    foreach(each IN LISTS kinds ITEMS ELSEWHERE)
        list(TRANSFORM room_${each} REPLACE "(.+)" "${CMAKE_CURRENT_SOURCE_DIR}/${name}/\\1.cpp")
        list(REMOVE_ITEM sources "" ${room_${each}})
    endforeach()
    list(APPEND room_${kind} ${sources})
    foreach(each IN LISTS kinds)
        set_property(GLOBAL PROPERTY RAYSTEPS_${name}_${each} ${room_${each}})
        set(${each} ${${each}} ${room_${each}} PARENT_SCOPE)
    endforeach()
endfunction()
