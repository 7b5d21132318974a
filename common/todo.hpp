// What is not written yet says so.
#pragma once

#include <mutex>

namespace rt {

/// "steps/…/sphere.cpp:12: intersect is not written yet", on the standard error stream.
void say_todo(const char* file, int line, const char* function);

/// Takes what nothing else uses.
template <class... Values>
void ignore(const Values&... /*values*/) {}

}  // namespace rt

/// A hole in a starter, in place of a function's body: says once that it is not written yet. Takes
/// the function's parameters, which nothing else uses as long as that is so.
#define RT_TODO(...)                                             \
    do {                                                         \
        static std::once_flag said;                              \
        std::call_once(said, ::rt::say_todo, __FILE__, __LINE__, \
                       static_cast<const char*>(__func__));      \
        ::rt::ignore(__VA_ARGS__);                               \
    } while (false)
