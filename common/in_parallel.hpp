// Many like pieces of work, shared among threads.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace rt {

/// Does the work for each number below count. Threads, so many at most, take the numbers in turn,
/// so that a costly stretch is shared. None is begun once `stop`, if there is one, is set. What a
/// piece throws is thrown here, after those that had begun have ended.
void in_parallel(int threads, std::size_t count, const std::atomic<bool>* stop,
                 const std::function<void(std::size_t)>& work);

}  // namespace rt
