// The reports on a class, as files.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/term.hpp"
#include "common/system/files.hpp"

#include <string>

namespace rt::grade {

/// Writes results/grades.csv: student, the points of each stage, total, maximum, and the term's
/// remarks on the student. Throws InputError.
void write_grade_book(const fs::path& results, const std::vector<Mark>& marks,
                      const Term& term = {});

/// Writes results/upload.csv, the roster with grades in the platform's import format, if the term
/// has a roster, and results/names.csv if the term is anonymous. Removes a file of an earlier run
/// that the term no longer requires. Returns a sentence on the grades in upload.csv, or nothing
/// without it. Throws InputError.
std::string write_upload(const fs::path& results, const std::vector<Mark>& marks, const Term& term);

/// Writes results/class.html: every stage of every student, changes by the term's rules, the known
/// mistakes, the hardest cases, the students whose code was stopped, and similar files (apart from
/// the starters in the project's folder). The edition is the date and the version on the page.
/// Throws InputError.
void write_class_report(const fs::path& results, const fs::path& project,
                        const std::vector<Mark>& marks, const Term& term = {},
                        const std::string& edition = "");

/// Writes results/students/<student>/feedback.html for each student with a submission: one file
/// that contains its pictures. Throws InputError.
void write_feedback(const fs::path& results, const std::vector<Mark>& marks, const Term& term = {});

/// Writes results/junit.xml: one testsuite per student and stage. Throws InputError.
void write_junit(const fs::path& results, const std::vector<Mark>& marks);

/// Throws InputError if the file exists and is neither empty nor a results.json, which a new one
/// may replace.
void check_gradescope_file(const fs::path& file);

/// Writes results.json from the marks of one student. Throws InputError.
void write_gradescope(const fs::path& file, const std::vector<Mark>& marks);

}  // namespace rt::grade
