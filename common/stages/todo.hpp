// The message of a function that the student has not written yet.
#pragma once

#include <mutex>

namespace rt {

/// Prints "steps/…/sphere.cpp:12: intersect is not written yet" on the standard error stream.
void say_todo(const char* file, int line, const char* function);

/// True if a function that is not written yet has been called.
[[nodiscard]] bool has_said_todo();

/// Uses its arguments, so that the compiler does not warn that they are unused.
template <class... Values>
void ignore(const Values&... /*values*/) {}

}  // namespace rt

/// A hole in a starter, in place of a function's body: prints once that the function is not written
/// yet. Its arguments are the function's parameters, which are unused until then.
#define RT_TODO(...)                                             \
    do {                                                         \
        static std::once_flag said;                              \
        std::call_once(said, ::rt::say_todo, __FILE__, __LINE__, \
                       static_cast<const char*>(__func__));      \
        ::rt::ignore(__VA_ARGS__);                               \
    } while (false)
