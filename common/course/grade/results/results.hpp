// The stored results of a submission: one file of JSON lines per stage.
#pragma once

#include "common/system/files.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// The last step of grading that a stage reached.
enum class Verdict {
    missing,    ///< no file was submitted
    refused,    ///< none compiles, or their compile was refused: `words` contains the reason
    judged,     ///< at least one of the stage's two files
    postponed,  ///< none, because the grader itself failed: the next run judges them
};

/// A case of one of the stage's suites.
struct CaseMark {
    std::string name;  ///< as in the suite: "edges belong to the triangle (MRT §5)"
    int points = 1;    ///< its points if it passes
    bool passed = false;
    bool given = false;     ///< the starter passes it: "a shape behind the origin is a miss"
    bool of_trace = false;  ///< a case of `trace`, not of the stage's functions
    std::string
        place;  ///< the place of its first failure: "tests/suites/step05_triangle_test.cpp:61"
    std::string words;     ///< the suite's message for that failure, several lines
    std::string failures;  ///< the digest of all its failures; not stored
};

/// The picture of the stage's scene, computed with the student's stages up to this one, and with
/// the references of missing or refused stages.
struct PictureMark {
    int pixels = 0;
    int different = 0;  ///< pixels that differ from the reference's picture, where that picture is
                        ///< certain
    std::string file;   ///< the student's picture, the reference's and the difference, in the same
                        ///< folder: a PNG
};

/// The stored result of one stage of a submission.
struct Mark {
    std::string student;
    int stage = 1;
    std::string key;  ///< hash of everything that decides the rest: the file, the suite, the seed
    Verdict verdict = Verdict::missing;
    std::string words;            ///< from the compiler or the grader
    std::string source;           ///< the SHA-256 of the functions' file; empty without one
    std::string trace_source;     ///< the same of `main.cpp`
    std::string mistake;          ///< the sentence of the recognized known mistake, if there is one
    std::string smallest;         ///< the smallest failing input, several lines, if one was found
    std::string slice;            ///< its drawing, in the same folder: an SVG
    std::vector<CaseMark> cases;  ///< in the suites' order; none of a file that was not tested
    std::optional<PictureMark> picture;
    int most = 0;  ///< the points of all the stage's cases, tested or not

    /// The points of the passed cases. A file whose passed cases the starter passes too has 0: the
    /// student wrote nothing.
    [[nodiscard]] int points() const;
    [[nodiscard]] int points(bool of_trace) const;
    /// The points of a file that was not submitted, or refused; of no file, if nothing was tested.
    [[nodiscard]] int untested_points() const;
};

/// In the results: the files of the class's folder that belong to no submission, with the reasons,
/// one line each.
inline constexpr const char* left_over_file = "left_over.txt";

/// In the results: each change of a mark by a later run, one line each.
inline constexpr const char* changes_file = "changes.csv";

/// In a student's folder: the page for the student.
inline constexpr const char* feedback_file = "feedback.html";

/// The files of the results that grading writes.
inline constexpr std::array report_files = {"grades.csv", "class.html",   "junit.xml", "upload.csv",
                                            "names.csv",  left_over_file, changes_file};

/// Throws InputError if the results would replace files of the lecturer's, or lie among the
/// submissions as one of them.
void check_results_folder(const fs::path& results, const std::vector<fs::path>& submissions);

/// "results/students/anna". A student's name never equals the name of one of the grader's files.
/// Throws InputError if no folder can have this name.
[[nodiscard]] fs::path student_folder(const fs::path& results, const std::string& student);

/// "results/students/anna/step05_triangle.jsonl"
[[nodiscard]] fs::path mark_file(const fs::path& results, const std::string& student, int stage);

/// Writes the mark whole, or not at all; before that, adds a line to the changes if it replaces
/// another number of points. Throws InputError.
void write_mark(const fs::path& results, const Mark& mark);

/// Returns nothing if the file does not exist, or is not a complete mark.
[[nodiscard]] std::optional<Mark> read_mark(const fs::path& results, const std::string& student,
                                            int stage);

/// The students who have a folder of marks: a folder with a feedback page alone belongs to a
/// student with another one's submission.
[[nodiscard]] std::vector<std::string> students_in(const fs::path& results);

/// Removes these pages; the next reports write them again. Throws filesystem_error.
void remove_shared_feedback(const fs::path& results);

/// All marks in the folder, by student and stage.
[[nodiscard]] std::vector<Mark> read_marks(const fs::path& results);

/// One sentence for each missing or postponed mark, "anna has no mark for step05_triangle": of each
/// student of the folder, and each stage for which others have a mark. Grading was interrupted, or
/// goes on, or has failed, or a file is damaged.
[[nodiscard]] std::vector<std::string> missing_marks(const fs::path& results,
                                                     const std::vector<Mark>& marks);

// The changes of marks by later runs, for the lecturer who answers for them.

/// Appends a line to results/changes.csv if the points differ: the date, the student, the stage,
/// the points before and after, and the reason. Other runs may append at the same time. Throws
/// InputError.
void record_change(const fs::path& results, const Mark& before, const Mark& after);

/// The number of bytes of that file; 0 without it.
[[nodiscard]] std::uintmax_t size_of_changes(const fs::path& results);

/// Its lines from that byte on.
[[nodiscard]] std::vector<std::string> changes_since(const fs::path& results, std::uintmax_t size);

// The classes that a folder of results is about: places, and the students who were there.

/// True if an earlier run has graded the student at this place, or if no run has had a class.
[[nodiscard]] bool is_graded_at(const fs::path& results, const fs::path& place,
                                const std::string& student);

/// Adds the students of a place to results/.classes. The place is a hash: results contain no names
/// of the machine's folders. Throws InputError.
void add_graded_class(const fs::path& results, const fs::path& place,
                      const std::vector<std::string>& students);

}  // namespace rt::grade
