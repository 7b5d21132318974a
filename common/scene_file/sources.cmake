# The sources of the scene reader, for the library and for the fuzzer, which compiles them with its
# own options. They call stage 2's basis_around.

set(raysteps_root ${CMAKE_CURRENT_LIST_DIR}/..)

# Sources without Real.
set(RAYSTEPS_SCENE_TEXT_SOURCES
    ${raysteps_root}/common/scene_file/decimal.cpp
    ${raysteps_root}/common/scene_file/element_line.cpp
    ${raysteps_root}/common/system/input_error.cpp
    ${raysteps_root}/common/system/input_file.cpp
    ${raysteps_root}/common/scene_file/lexer.cpp
    ${raysteps_root}/common/scene_file/diagnostics.cpp)

# Sources compiled once for each precision.
set(RAYSTEPS_SCENE_REAL_SOURCES
    ${raysteps_root}/common/geometry/bounds.cpp
    ${raysteps_root}/common/scene/camera.cpp
    ${raysteps_root}/common/scene_file/elements.cpp
    ${raysteps_root}/common/scene_file/fields.cpp
    ${raysteps_root}/common/scene_file/reader.cpp)
