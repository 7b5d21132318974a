// The render queue: one rendering at a time, and only the latest request of each page.
#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <list>
#include <mutex>

namespace rt {

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
