// In place of common/system/parallel_for.cpp.
#include "common/system/parallel_for.hpp"

void rt::parallel_for(int /*threads*/, std::size_t count, const std::atomic<bool>* /*stop*/,
                      const std::function<void(std::size_t)>& work) {
    for (std::size_t i = 0; i < count; ++i) work(i);
}
