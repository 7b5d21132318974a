// Numbers and names of the stages.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace rt {

inline constexpr auto stage_names = std::to_array<std::string_view>({
    "step01_ray_generation",
    "step02_camera_basis",
    "step03_sphere",
    "step04_plane",
    "step05_triangle",
    "step06_square",
    "step07_cylinder",
    "step08_cone",
    "step09_phong",
    "step10_shadows",
    "step11_soft_shadows",
    "step12_mirror",
    "step13_meshes",
});

// The stages that introduce shapes, light, and so on.
inline constexpr int shapes_stage = 3;
inline constexpr int light_stage = 9;
inline constexpr int soft_shadow_stage = 11;
inline constexpr int mirror_stage = 12;
inline constexpr int mesh_stage = 13;

/// The name of a stage from 1 on.
[[nodiscard]] constexpr std::string_view stage_name(int stage) {
    return stage_names.at(static_cast<std::size_t>(stage - 1));
}

/// The same, for longer names.
[[nodiscard]] inline std::string name_of(int stage) {
    return std::string(stage_name(stage));
}

/// The topic of a stage, the name of its files: "triangle".
[[nodiscard]] inline std::string topic_of(int stage) {
    return std::string(stage_name(stage).substr(std::string_view("stepNN_").size()));
}

/// The number of the stage that "5", "05", "step05", "triangle" or "step05_triangle" names; nothing
/// for other text.
[[nodiscard]] std::optional<int> find_stage(std::string_view text);

// Lists of stages, as options name them.

/// The stages that "1-5,9,mirror" names, each as find_stage reads it; nothing for other text, or
/// for a range that is not in order.
[[nodiscard]] std::optional<std::set<int>> find_stages(std::string_view text);

}  // namespace rt
