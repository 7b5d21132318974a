// The output of `./course check`: one screen, or with --all every result.
#pragma once

#include "common/course/exercise/diagnosis.hpp"
#include "common/course/exercise/judgment.hpp"
#include "common/course/exercise/telling_case.hpp"
#include "common/course/exercise/workbook.hpp"

namespace rt {

/// The results of a check, the diagnosis, and the part to mend first.
struct Findings {
    Judgment judgment;
    Diagnosis diagnosis;
    KnownCases known;
    std::string part;  ///< to write or to mend next; empty if all cases pass
};

[[nodiscard]] Findings findings_of(int stage, Judgment judgment, Diagnosis diagnosis);

/// Prints the verdict in one line.
void show_verdict(int stage, const Judgment& judgment);

/// Prints the sentences on known mistakes, and what is not written; with `complete` also the names
/// of the mistakes and every case. Returns the number of lines.
int show_diagnosis(int stage, const Findings& findings, bool complete);

/// Prints the most telling failure, with `complete` also the lines to paste. Without, what does not
/// fit on the terminal beside as many other rows is left out: first the plainer call, then the end
/// of the question.
void show_failure(int stage, const Findings& findings, bool complete, int other_rows);

/// Prints what to do next. `draws` is false if all cases pass and the picture does not.
void show_next_step(const Workbook& workbook, const Findings& findings, bool draws);

}  // namespace rt
