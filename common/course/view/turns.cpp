#include "common/course/view/turns.hpp"

namespace rt {

bool Turns::take(int page, const Work& work) {
    std::unique_lock lock(mutex_);
    for (Turn& turn : turns_)
        if (turn.page == page) turn.cancelled = true;
    changed_.notify_all();
    Turn& turn = turns_.emplace_back();
    turn.page = page;
    turn.cancelled = over_;
    changed_.wait(lock, [&] { return turn.cancelled || &turn == &turns_.front(); });
    if (!turn.cancelled) {
        lock.unlock();
        work(turn.cancelled);
        lock.lock();
    }
    const bool finished = !turn.cancelled;
    turns_.remove_if([&](const Turn& other) { return &other == &turn; });
    changed_.notify_all();
    return finished;
}

void Turns::cancel_all() {
    const std::scoped_lock lock(mutex_);
    over_ = true;
    for (Turn& turn : turns_) turn.cancelled = true;
    changed_.notify_all();
}

}  // namespace rt
