# The sources of the scene reader, for the library and for the fuzzer, which compiles them with its
# own options. They call stage 2's basis_around.

set(raysteps_root ${CMAKE_CURRENT_LIST_DIR}/..)

# Sources without Real.
set(RAYSTEPS_SCENE_TEXT_SOURCES
    ${raysteps_root}/common/decimal.cpp
    ${raysteps_root}/common/element_line.cpp
    ${raysteps_root}/common/input_error.cpp
    ${raysteps_root}/common/input_file.cpp
    ${raysteps_root}/common/scene_lexer.cpp
    ${raysteps_root}/common/scene_report.cpp)

# Sources compiled once for each precision.
set(RAYSTEPS_SCENE_REAL_SOURCES
    ${raysteps_root}/common/bounds.cpp
    ${raysteps_root}/common/scene.cpp
    ${raysteps_root}/common/scene_elements.cpp
    ${raysteps_root}/common/scene_fields.cpp
    ${raysteps_root}/common/scene_reader.cpp)
