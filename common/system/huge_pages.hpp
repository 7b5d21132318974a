// Huge pages, for arrays that rays read in no order.
#pragma once

#include <cstddef>
#include <vector>

namespace rt {

/// Requests pages of 2 MiB, in place of 4 KiB, for memory that nothing was written to yet: the
/// processor then finds the pages of many more addresses in its translation buffer, and the system
/// provides them in fewer steps. Only a request: nothing happens where the system has no such
/// pages, or for less memory than one of them.
void request_huge_pages(void* memory, std::size_t bytes);

/// Reserves memory for `count` items in an empty vector, and requests huge pages for it.
template <class T>
void reserve_huge(std::vector<T>& items, std::size_t count) {
    items.reserve(count);
    request_huge_pages(items.data(), items.capacity() * sizeof(T));
}

}  // namespace rt
