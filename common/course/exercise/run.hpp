// The commands that build a program, and hand over to it. Each returns the program's exit status.
#pragma once

#include "common/system/process.hpp"

#include <optional>

namespace rt {

/// `./course run`: the stage's program, of the student's files of all started stages but
/// `references` ("3;5").
int run_stage(int stage, const Command& words, const std::string& references);

/// `./course test`: the stage's suite, or all tests, with options for ctest.
int run_tests(std::optional<int> stage, const Command& words);

/// `./course grade`: the grader, a separate program that students do not get.
int run_grader(const Command& words);

}  // namespace rt
