// In place of what Debian's C++ library for WebAssembly lacks: a page has one thread, which does
// at once what another would do. Included before every file.
#pragma once

// These two headers refuse to be included without threads.
#define _LIBCPP_FUTURE
#define _LIBCPP_THREAD

#include <optional>
#include <type_traits>
#include <utility>

namespace std {  // NOLINT: only for the engine

template <class Value>
struct future {
    optional<Value> value;
    Value get() { return *std::move(value); }
    [[nodiscard]] bool valid() const { return value.has_value(); }
};

template <>
struct future<void> {
    void wait() const {}
};

template <class Work>
auto async(Work work) -> future<decltype(work())> {
    if constexpr (is_void_v<decltype(work())>) {
        work();
        return {};
    } else {
        return {work()};
    }
}

}  // namespace std
