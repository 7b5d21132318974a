// The commands of `./course` about a stage.
#pragma once

#include "common/course/exercise/two_programs.hpp"
#include "common/system/process.hpp"

#include <optional>
#include <string>

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

/// Builds the student's file of the stage and tests it with the references of all other stages, in
/// both precisions. Prints one screen: how many cases pass, the most telling failure, and where the
/// picture is beside the reference's; with `complete` everything. Returns 0 if all cases pass, else
/// 1.
int check(int stage, bool complete = false);

/// Draws the picture of the checked files, by the program stepNN_name_checked (common/cmake/
/// stage.cmake), and writes it beside the reference's to a file, whose path it prints. They are
/// small, to be drawn in a moment; `./course compare` draws the whole ones. `is_wrong` is true if
/// a case fails: then the same picture is no praise. Returns false if the program draws none, or
/// another one with one thread.
[[nodiscard]] bool show_picture(int stage, bool is_wrong);

/// Runs the suites with the student's files compiled with AddressSanitizer and
/// UndefinedBehaviorSanitizer, and prints the first error that these find. Returns 0 if there is
/// none, else 1.
int check_with_sanitizers(int stage);

/// Checks the stage, and again whenever a file of it is saved, until Ctrl-C. On a terminal, each
/// check has a screen of its own, and keys: r checks again, h shows a hint, n goes on to the next
/// stage once this one passes, l lists the stages, q ends.
void watch(int stage);

/// `./course explain`: prints where both explanations of the pixel "ROW,COLUMN" differ, the first
/// difference first; if it is empty, of the middle of the largest cluster of different pixels; and
/// if none differs, of the first failing question of the last check. Returns 0.
int explain_pixel(const ComparisonRequest& contest, std::string pixel);

/// `./course compare`: writes both pictures and their difference to renders/, and shows them on a
/// terminal. Returns 0 if they agree, else 1. Throws InputError if the student's program takes
/// longer than ten seconds, and twenty times as long as the reference's.
int compare_pictures(const ComparisonRequest& contest);

/// Builds the suite with the student's files compiled for a debugger, and starts gdb or lldb at the
/// last call of a student's function before the first failure of a case: of the one whose name
/// contains the words, or if there are none, of the first that failed in the last check. Throws
/// InputError without a debugger, such a case or a failure. Returns the debugger's exit status.
/// Unless it `starts` one, it only prepares the program, for an editor (.vscode/launch.json).
int debug(int stage, const std::string& words, bool starts);

/// `./course run`: the stage's program, of the student's files of all started stages but
/// `references` ("3;5").
int run_stage(int stage, const Command& words, const std::string& references);

/// `./course test`: the stage's suite, or all tests, with options for ctest.
int run_tests(std::optional<int> stage, const Command& words);

/// `./course grade`: the grader, a separate program that students do not get.
int run_grader(const Command& words);

}  // namespace rt
