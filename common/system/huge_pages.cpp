#include "common/system/huge_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>  // madvise, which standard C++ does not have
#endif

#include <memory>

namespace rt {

void request_huge_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    // Linux provides them if asked to, by its default setting; macOS and Windows have no request.
    constexpr std::size_t size = std::size_t(2) << 20;
    if (std::align(size, size, memory, bytes) != nullptr)
        madvise(memory, bytes - bytes % size, MADV_HUGEPAGE);
#endif
}

}  // namespace rt
