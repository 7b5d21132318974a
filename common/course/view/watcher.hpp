// Sees when there is something new to show.
#pragma once

#include "common/course/view/view.hpp"

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <string>
#include <thread>

namespace rt {

/// What is new of a stage.
struct News {
    std::string programs;  ///< changes whenever the programs or the scene do
    bool building = false;
    std::string error = "";  ///< of the last build

    bool operator==(const News&) const = default;
};

/// Looks at the files of those stages that somebody looks at.
class Watcher {
public:
    explicit Watcher(const ViewSettings& settings);
    ~Watcher() { stop(); }
    Watcher(const Watcher&) = delete;
    Watcher& operator=(const Watcher&) = delete;

    /// The stage's news as soon as they are not what was `seen`, by their fingerprint; after half
    /// a minute, or once the same page asks again, whatever they are.
    [[nodiscard]] News wait(int page, int stage, const std::string& seen);
    /// Nobody waits any more.
    void stop();

private:
    using Clock = std::chrono::steady_clock;

    struct Stage {
        News news;
        std::string built_from;
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
    std::map<int, int> asked_by_;  // page: how often
    bool over_ = false;
    std::thread thread_;
};

/// A word that is another whenever the news are.
[[nodiscard]] std::string fingerprint(const News& news);

}  // namespace rt
