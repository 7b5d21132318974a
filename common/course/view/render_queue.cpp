#include "common/course/view/render_queue.hpp"

namespace rt {

bool RenderQueue::take(int page, int number, const Work& work) {
    Turn& turn = enter(page, number);
    try {
        if (!turn.cancelled) work(turn.cancelled);
    } catch (...) {
        leave(turn);
        throw;
    }
    return leave(turn);
}

RenderQueue::Turn& RenderQueue::enter(int page, int number) {
    std::unique_lock lock(mutex_);
    bool is_latest = true;
    for (Turn& turn : turns_) {
        if (turn.page != page) continue;
        if (turn.number > number)
            is_latest = false;
        else
            turn.cancelled = true;
    }
    changed_.notify_all();
    Turn& turn = turns_.emplace_back();
    turn.page = page;
    turn.number = number;
    turn.cancelled = over_ || !is_latest;
    changed_.wait(lock, [&] { return turn.cancelled || &turn == &turns_.front(); });
    return turn;
}

bool RenderQueue::leave(const Turn& turn) {
    const std::scoped_lock lock(mutex_);
    const bool finished = !turn.cancelled;
    turns_.remove_if([&](const Turn& other) { return &other == &turn; });
    changed_.notify_all();
    return finished;
}

void RenderQueue::cancel_all() {
    const std::scoped_lock lock(mutex_);
    over_ = true;
    for (Turn& turn : turns_) turn.cancelled = true;
    changed_.notify_all();
}

}  // namespace rt
