// What the two programs are asked to draw, and to tell.
#pragma once

#include "common/course/files.hpp"
#include "common/course/view/view.hpp"
#include "common/stages.hpp"

#include "common/course/process.hpp"

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt {

enum class Whose { mine, reference };

/// A camera as somebody turns it: degrees to the right of −z, and above the horizon.
struct TurnedCamera {
    double x = 0;
    double y = 0;
    double z = 0;
    double yaw = 0;
    double pitch = 0;
    double fov = 60;
};

/// What a stage's scene says of how it is seen.
struct SceneView {
    int width = 640;
    int height = 480;
    std::optional<TurnedCamera> camera;
};

/// What the sliders say.
struct Drawing {
    int stage = 1;
    std::optional<TurnedCamera> camera;  ///< the scene's own if there is none
    int shrink = 1;                      ///< divides the scene's size
    std::vector<std::string> options;    ///< of the program
};

struct Picture {
    std::string png;     ///< empty if there is none
    std::string report;  ///< what the program said
};

[[nodiscard]] std::filesystem::path program(const ViewSettings& settings, int stage, Whose whose);
[[nodiscard]] std::filesystem::path scene_file(const ViewSettings& settings, int stage);
/// The files that the student has written; none if the stage is not started.
[[nodiscard]] std::vector<std::filesystem::path> student_files(const ViewSettings& settings,
                                                               int stage);
[[nodiscard]] SceneView scene_view(const ViewSettings& settings, int stage);

/// Runs the programs, in a temporary folder that lives as long as it does.
class Studio {
public:
    explicit Studio(const ViewSettings& settings);

    [[nodiscard]] Picture draw(const Drawing& drawing, Whose whose,
                               const std::atomic<bool>& cancelled);
    /// The story of a pixel, as mine and as the reference tell it.
    [[nodiscard]] std::vector<std::string> stories(const Drawing& drawing, int row, int column,
                                                   const std::atomic<bool>& cancelled);

private:
    /// The scene seen by the drawing's camera.
    [[nodiscard]] std::filesystem::path scene_of(const Drawing& drawing);
    /// What the program said, and last how it ended if that was not well.
    [[nodiscard]] Ending run(const Drawing& drawing, Whose whose, const std::string& scene,
                             const Command& rest, const std::atomic<bool>& cancelled) const;

    const ViewSettings& settings_;
    TemporaryFolder folder_;
    std::atomic<int> files_ = 0;
};

}  // namespace rt
