// The runs of the student's and the reference's program: pictures and explanations.
#pragma once

#include "common/course/view/view.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace rt {

enum class Whose { mine, reference };

/// The camera after a turn: degrees to the right of −z, and above the horizon.
struct TurnedCamera {
    double x = 0;
    double y = 0;
    double z = 0;
    double yaw = 0;
    double pitch = 0;
    double fov = 60;
};

/// The camera and size of a stage's scene.
struct SceneView {
    int width = 640;
    int height = 480;
    std::optional<TurnedCamera> camera;
};

/// The settings of the sliders.
struct RenderRequest {
    int stage = 1;
    std::optional<TurnedCamera> camera;  ///< if empty, the scene's own
    int shrink = 1;                      ///< divides the scene's size
    std::vector<std::string> options;    ///< of the program
};

struct Picture {
    std::string png;     ///< empty on failure
    std::string report;  ///< the program's output
};

[[nodiscard]] fs::path program(const ViewSettings& settings, int stage, Whose whose);
[[nodiscard]] fs::path scene_file(const ViewSettings& settings, int stage);
/// The student's files; empty if the stage is not started.
[[nodiscard]] std::vector<fs::path> student_files(const ViewSettings& settings, int stage);
[[nodiscard]] SceneView scene_view(const ViewSettings& settings, int stage);

/// Runs the programs, in a temporary folder with the lifetime of this object.
class StageRunner {
public:
    explicit StageRunner(const ViewSettings& settings);

    [[nodiscard]] Picture draw(const RenderRequest& picture_request, Whose whose,
                               const std::atomic<bool>& cancelled);
    /// The output of the student's and of the reference's program about a pixel: with `--pixel` its
    /// explanation, with `--rays` the drawing of its rays.
    [[nodiscard]] std::vector<std::string> about_pixel(const RenderRequest& picture_request,
                                                       const std::string& option, int row,
                                                       int column,
                                                       const std::atomic<bool>& cancelled);

private:
    /// The scene with the drawing's camera.
    [[nodiscard]] fs::path scene_of(const RenderRequest& picture_request);
    /// The program's output, and last its exit status if it failed.
    [[nodiscard]] ProcessResult run(const RenderRequest& picture_request, Whose whose,
                                    const std::string& scene, const Command& rest,
                                    const std::atomic<bool>& cancelled) const;

    const ViewSettings& settings_;
    TemporaryFolder folder_;
    std::atomic<int> files_ = 0;
};

// The render queue: one rendering at a time, and only the latest request of each page.

class RenderQueue {
public:
    using Work = std::function<void(const std::atomic<bool>& cancelled)>;

    /// Cancels the page's earlier requests, waits for its turn, and runs the work. Returns false if
    /// the page sent a later request meanwhile, or everything was cancelled. A page numbers its
    /// requests in order, since they may arrive in another one.
    bool take(int page, int number, const Work& work);

    /// Cancels all present and future requests.
    void cancel_all();

private:
    struct Turn {
        int page = 0;
        int number = 0;
        std::atomic<bool> cancelled = false;
    };

    Turn& enter(int page, int number);
    /// Returns false if it was cancelled.
    bool leave(const Turn& turn);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<Turn> turns_;  // the first one runs
    bool over_ = false;
};

}  // namespace rt
