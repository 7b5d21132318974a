// Detects new programs and scenes.
#pragma once

#include "common/course/view/view.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace rt {

/// The state of a stage.
struct StageStatus {
    std::string programs;  ///< changes with the programs or the scene
    bool building = false;
    std::string error = "";  ///< of the last build

    bool operator==(const StageStatus&) const = default;
};

/// Watches the files of the stages that a page shows.
class Watcher {
public:
    explicit Watcher(const ViewSettings& settings);
    ~Watcher() { stop(); }
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;

    /// Returns the stage's state as soon as its fingerprint differs from `seen`; after half a
    /// minute, or when the same page sends another request, returns it unchanged.
    [[nodiscard]] StageStatus wait(int page, int stage, const std::string& seen);
    /// Ends all waiting calls.
    void stop();

private:
    using Clock = std::chrono::steady_clock;

    struct Stage {
        StageStatus news;
        std::optional<std::string> built_from;  ///< nothing before the first build
        Clock::time_point asked;
    };

    void watch();
    void look_at(int stage, std::unique_lock<std::mutex>& lock);
    [[nodiscard]] std::string programs(int stage) const;
    [[nodiscard]] std::string sources() const;

    const ViewSettings& settings_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::map<int, Stage> stages_;
    std::map<int, int> asked_by_;  // page: number of requests
    bool over_ = false;
    std::thread thread_;
};

/// A text that changes whenever the state does.
[[nodiscard]] std::string fingerprint(const StageStatus& news);

}  // namespace rt
