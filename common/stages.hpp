// The thirteen stages by number and name.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace rt {

inline constexpr std::array<std::string_view, 13> stage_names = {
    "step01_ray_generation", "step02_camera_basis", "step03_sphere",       "step04_plane",
    "step05_triangle",       "step06_square",       "step07_cylinder",     "step08_cone",
    "step09_phong",          "step10_shadows",      "step11_soft_shadows", "step12_mirror",
    "step13_meshes",
};

// What the programs ask the number of: the stages that bring shapes, light, and so on.
inline constexpr int shapes_stage = 3;
inline constexpr int light_stage = 9;
inline constexpr int soft_shadow_stage = 11;
inline constexpr int mirror_stage = 12;
inline constexpr int mesh_stage = 13;

/// The name of a stage, 1 to 13.
[[nodiscard]] constexpr std::string_view stage_name(int stage) {
    return stage_names.at(static_cast<std::size_t>(stage - 1));
}

/// The stage that somebody means by "5", "05", "step05", "triangle" or "step05_triangle"; nothing
/// if it is none of these.
[[nodiscard]] std::optional<int> find_stage(std::string_view text);

}  // namespace rt
