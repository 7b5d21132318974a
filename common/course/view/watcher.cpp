#include "common/course/view/watcher.hpp"

#include "common/course/view/stage_runner.hpp"
#include "common/system/files.hpp"

#include <cstdint>
#include <functional>

namespace rt {

namespace {

constexpr std::chrono::milliseconds between_looks{150};
constexpr std::chrono::seconds longest_wait{30};
constexpr std::chrono::seconds forgotten_after{60};

/// Changes whenever the file is written or replaced; empty if there is no file.
std::string stamp(const fs::path& file) {
    std::error_code none;
    // libc++ counts it in __int128, which to_string does not take.
    const auto time = std::int64_t(fs::last_write_time(file, none).time_since_epoch().count());
    const auto size = fs::file_size(file, none);
    return none ? "" : std::to_string(time) + "." + std::to_string(size);
}

}  // namespace

Watcher::Watcher(const ViewSettings& settings)
    : settings_(settings), thread_([this] { watch(); }) {}

void Watcher::stop() {
    {
        const std::scoped_lock lock(mutex_);
        over_ = true;
    }
    changed_.notify_all();
    if (thread_.joinable()) thread_.join();
}

StageStatus Watcher::wait(int page, int stage, const std::string& seen) {
    std::unique_lock lock(mutex_);
    const int question = ++asked_by_[page];
    changed_.notify_all();
    Stage& asked = stages_[stage];
    asked.asked = Clock::now();
    if (asked.news.programs.empty()) asked.news.programs = programs(stage);
    changed_.wait_for(lock, longest_wait, [&] {
        return over_ || asked_by_[page] != question || fingerprint(asked.news) != seen;
    });
    return asked.news;
}

void Watcher::watch() {
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, between_looks, [this] { return over_; }))
        for (int stage = 1; stage <= int(stage_names.size()); ++stage)
            if (stages_.contains(stage)) look_at(stage, lock);
}

void Watcher::look_at(int stage, std::unique_lock<std::mutex>& lock) {
    Stage& watched = stages_[stage];
    if (Clock::now() - watched.asked > forgotten_after) return;
    const StageStatus before = watched.news;
    const std::string now = sources();
    if (settings_.rebuild && watched.built_from != now) {
        watched.news.building = true;
        changed_.notify_all();
        lock.unlock();
        std::string error;
        try {
            error = settings_.rebuild(stage);
        } catch (const std::exception& failure) {
            error = failure.what();
        }
        lock.lock();
        watched.news.building = false;
        watched.news.error = error;
        watched.built_from = now;
    }
    watched.news.programs = programs(stage);
    if (watched.news != before) changed_.notify_all();
}

std::string Watcher::programs(int stage) const {
    return stamp(program(settings_, stage, Whose::mine)) + "_" +
           stamp(program(settings_, stage, Whose::reference)) + "_" +
           stamp(scene_file(settings_, stage));
}

std::string Watcher::sources() const {
    std::string all;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        for (const fs::path& file : student_files(settings_, stage))
            all += file.string() + stamp(file);
    return all;
}

std::string fingerprint(const StageStatus& news) {
    const std::size_t error = std::hash<std::string>()(news.error);
    return news.programs + (news.building ? "_building_" : "_") + std::to_string(error);
}

}  // namespace rt
