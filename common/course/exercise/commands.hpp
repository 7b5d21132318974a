// The short commands about a stage's files: their state, start, reset, hint, solution.
#pragma once

#include <optional>

namespace rt {

/// `./course`: prints one line for each stage.
void show_progress();

/// Prints the command to type next.
void show_next();

/// `./course start`: copies the starter, and prints the paths of what to write and read. Throws
/// InputError if the stage is started already.
void start(int stage);

/// `./course reset`: keeps the student's files in a new folder, and copies the starter again.
/// Throws InputError if the stage is not started.
void reset(int stage);

/// `./course hint`: prints the next hint, or the one of this level, and counts it.
void show_hint(int stage, std::optional<int> level);

/// `./course solution`: prints the reference and returns 0 if the stage is done or at the second
/// call; else returns 1. Throws InputError in a hand-out without solutions.
int show_solution(int stage);

}  // namespace rt
