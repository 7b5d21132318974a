// A handmade class with known marks.
#pragma once

#include "common/course/grade/reports/reports.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

/// A possible folder name in an untrusted archive: a formula, a tag, quotes, a line end.
inline const std::string odd = "=cmd|\"<b>&\n";

/// Output of untrusted code that is not UTF-8.
inline const std::string no_utf8 = "got: \xff\xc3(";

/// True if the text contains the part.
[[nodiscard]] inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A folder of results that is removed at the end of its scope.
struct Results {
    TemporaryFolder temporary;
    std::filesystem::path folder = temporary.path();
};

/// Two students, stages 4 and 5, of 2 and 4 points. The odd one has 1 point of stage 4, and stage 5
/// is refused; zoe did not submit stage 4, and has 3 points of stage 5.
[[nodiscard]] std::vector<Mark> class_of_two();

// A handmade class with a lecturer's settings.

/// A class without students; stages and points are added.
struct TermClass : Results {
    void add(const std::string& student, int stage, int points, int most) {
        marks.push_back({.student = student,
                         .stage = stage,
                         .verdict = Verdict::judged,
                         .cases = {{.name = "passed", .points = points, .passed = true},
                                   {.name = "failed", .points = most - points}},
                         .most = most});
    }
    void write(const std::string& file, const std::string& text) const {
        write_text(folder / file, text);
    }

    [[nodiscard]] Term term() const { return read_term(folder, marks); }

    [[nodiscard]] std::string book() const {
        write_grade_book(folder, marks, term());
        return read_text(folder / "grades.csv");
    }

    /// The error message about the settings.
    [[nodiscard]] std::string error() const {
        try {
            (void)term();
        } catch (const InputError& error) {
            return error.what();
        }
        return "none";
    }

    /// The grades for the platform.
    [[nodiscard]] std::string upload() const {
        (void)write_upload(folder, marks, term());
        return read_text(folder / "upload.csv");
    }

    std::vector<Mark> marks;
};

/// Stages 3 and 5, of 4 and 10 points: ann_1 has 3 and 5, ben_2 has 4 and nothing.
struct Small : TermClass {
    Small() {
        add("ann_1", 3, 3, 4);
        add("ann_1", 5, 5, 10);
        add("ben_2", 3, 4, 4);
        marks.push_back({.student = "ben_2", .stage = 5, .verdict = Verdict::missing, .most = 10});
        for (const Mark& mark : marks) write_mark(folder, mark);
    }
};

}  // namespace rt::grade
