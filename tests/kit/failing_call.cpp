// Stops a debugger in the call that fails, in the programs of `./course debug`. The student's files
// are compiled with -finstrument-functions: the compiler calls the functions here at the start and
// at the end of each of theirs.
//
// RAYSTEPS_CALLS    a file to which the number of calls until the first failure is written
// RAYSTEPS_STOP_AT  such a number: this call stops in raysteps_stop(), which its caller is the call
// of
#include "tests/kit/report.hpp"

#include <atomic>
#include <cstdlib>
#include <fstream>

extern "C" {
void raysteps_stop();
void __cyg_profile_func_enter(void* function, void* caller);
void __cyg_profile_func_exit(void* function, void* caller);
}

namespace {

std::atomic<long> calls{0};
thread_local int depth = 0;  // a function that another of the student's calls is no question

long number_of(const char* variable) {
    const char* const text = std::getenv(variable);
    return text == nullptr ? 0 : std::atol(text);
}

const long stop_at = number_of("RAYSTEPS_STOP_AT");

const bool is_set = [] {
    rt::at_first_failure = [] {
        if (const char* const file = std::getenv("RAYSTEPS_CALLS")) {
            std::ofstream(file) << calls << '\n';
            std::_Exit(1);
        }
    };
    return true;
}();

}  // namespace

/// A debugger's breakpoint.
[[gnu::noinline]] void raysteps_stop() {
    static std::atomic<int> stops{0};
    ++stops;
}

void __cyg_profile_func_enter(void* /*function*/, void* /*caller*/) {
    if (depth++ == 0 && ++calls == stop_at) raysteps_stop();
}

void __cyg_profile_func_exit(void* /*function*/, void* /*caller*/) {
    --depth;
}
