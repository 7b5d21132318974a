#include "common/stages/todo.hpp"

#include "common/stages/reasons.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace rt {

namespace {

std::atomic<bool> has_said = false;

}  // namespace

bool has_said_todo() {
    return has_said;
}

void say_todo(const char* file, int line, const char* function) {
    has_said = true;
    // Prints the path from the project's folder, wherever that is.
    const std::string_view path(file);
    const std::size_t start = path.rfind("steps/step");
    const char* const own = std::getenv("RAYSTEPS_NOT_WRITTEN");  // in the reader's language
    std::fprintf(stderr, "%s:%d: %s%s\n", file + (start == std::string_view::npos ? 0 : start),
                 line, function, own != nullptr ? own : not_written);
}

}  // namespace rt
