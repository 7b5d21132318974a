// `./course own` on a project of a test's own: own_course PROJECT DIR, or, for --check,
// own_course PROJECT DIR REFERENCE_PROGRAM SECONDS.
#include "common/course/own/own.hpp"

#include "common/system/input_error.hpp"

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv) {
    try {
        if (argc == 3) return rt::lay_out_own(argv[1], argv[2]);
        if (argc == 5)
            return rt::check_own({.program = rt::own_program(argv[2]),
                                  .reference = argv[3],
                                  .project = argv[1],
                                  .limit = std::chrono::seconds(std::atoi(argv[4]))});
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
    }
    return 2;
}
