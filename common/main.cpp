// The program of every stage: CMake says which.
#include "common/input_error.hpp"
#include "common/options.hpp"

#include <atomic>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace rt {

#ifndef RT_EXACT
inline namespace f32 {
bool run(const Program& program, const Options& options, const std::atomic<bool>& stop);
}
#endif
inline namespace f64 {
bool run(const Program& program, const Options& options, const std::atomic<bool>& stop);
}

}  // namespace rt

namespace {

constexpr int bad_input = 2;
constexpr int interrupted = 130;  // as shells count it: 128 + SIGINT

std::atomic<bool> stop = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler sets it");

void on_interrupt(int /*signal*/) {
    stop = true;
}

int run_program(int argc, char** argv) {
#ifdef RT_EXACT
    constexpr bool exact = true;
#else
    constexpr bool exact = false;
#endif
    const rt::Program program{.stage = RAYSTEPS_STAGE, .root = RAYSTEPS_ROOT, .exact = exact};
    const auto options = rt::parse_options(program, argc, argv);
    if (!options) return 0;
    auto run = rt::f64::run;
#ifndef RT_EXACT
    if (options->precision == rt::Precision::f32) run = rt::f32::run;
#endif
    return run(program, *options, stop) ? 0 : interrupted;
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, on_interrupt);
    try {
        return run_program(argc, argv);
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
    } catch (const std::bad_alloc&) {
        std::cerr << "error: not enough memory for this\n";
    } catch (const std::exception& error) {  // of the system, which has no more to give
        std::cerr << "error: " << error.what() << '\n';
    }
    return bad_input;
}
