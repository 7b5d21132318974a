#include "common/system/parallel_for.hpp"

#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace rt {

void parallel_for(int threads, std::size_t count, const std::atomic<bool>* stop,
                  const std::function<void(std::size_t)>& work) {
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto run = [&] {
        try {
            for (std::size_t i = next++; i < count; i = next++) {
                if (stop != nullptr && *stop) return;
                work(i);
            }
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            failure = std::current_exception();
        }
    };
    std::vector<std::thread> others;
    try {
        for (int i = 1; i < threads && std::size_t(i) < count; ++i) others.emplace_back(run);
    } catch (const std::system_error&) {
        // The system has no more threads: the existing ones do all the work.
    }
    run();
    for (std::thread& thread : others) thread.join();
    if (failure) std::rethrow_exception(failure);
}

}  // namespace rt
