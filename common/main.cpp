// The program of every stage: CMake says which.
#include "common/input_error.hpp"
#include "common/options.hpp"

#include <atomic>
#include <csignal>
#include <exception>
#include <iostream>
#include <new>

namespace rt {

inline namespace f32 {
bool run(const Program& program, const Options& options, const std::atomic<bool>& stop);
}
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
    const rt::Program program{.stage = RAYSTEPS_STAGE, .root = RAYSTEPS_ROOT};
    const auto options = rt::parse_options(program, argc, argv);
    if (!options) return 0;
    const auto run = options->precision == rt::Precision::f32 ? rt::f32::run : rt::f64::run;
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
