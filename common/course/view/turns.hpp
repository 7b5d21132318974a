// Who may draw: one at a time, and of each page only what it asked for last.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace rt {

class Turns {
public:
    using Work = std::function<void(const std::atomic<bool>& cancelled)>;

    /// Cancels what the same page asked for before, waits for its turn, and works. Returns false if
    /// the page asked for something else meanwhile, or all was cancelled.
    bool take(int page, const Work& work);

    /// Everything, now and from now on.
    void cancel_all();

private:
    struct Turn {
        int page = 0;
        std::atomic<bool> cancelled = false;
    };

    Turn& enter(int page);
    /// Returns whether it was not cancelled.
    bool leave(const Turn& turn);

    std::mutex mutex_;
    std::condition_variable changed_;
    std::list<Turn> turns_;  // the first one's it is
    bool over_ = false;
};

}  // namespace rt
