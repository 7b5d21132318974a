// A parallel for loop over independent pieces of work.
#pragma once

#include <atomic>
#include <cstddef>
#include <functional>

namespace rt {

/// Calls work(i) for every i below count, on at most `threads` threads, which take the numbers in
/// turn so that an expensive stretch is shared. Stops starting new work when `*stop` becomes true;
/// `stop` may be null. Rethrows the first exception after all threads have finished.
void parallel_for(int threads, std::size_t count, const std::atomic<bool>* stop,
                  const std::function<void(std::size_t)>& work);

}  // namespace rt
