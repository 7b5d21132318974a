// What is known of a submission: a file for each of its stages, of JSON lines.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// How far the judging of a stage came.
enum class Verdict {
    missing,  ///< no file was handed in
    refused,  ///< it does not compile, or is not for us to compile: `words` says why
    judged,
};

/// A case of the stage's suite.
struct CaseMark {
    std::string name;  ///< as in the suite: "edges belong to the triangle (MRT §5)"
    int points = 1;    ///< what it is worth
    bool passed = false;
    bool given = false;  ///< the starter passes it: "behind the origin, nothing is met"
    std::string place;   ///< "tests/step05_triangle_test.cpp:61": its first failure
    std::string words;   ///< what the suite says of that, several lines
};

/// The picture of the stage's scene, by the student's own stages up to this one; by the references
/// of those that are missing or refused.
struct PictureMark {
    int pixels = 0;
    int different = 0;  ///< from the reference's picture, where that is certain
    std::string file;   ///< mine, the reference's and the difference, in the same folder: a PNG
};

/// What is known of a stage of a submission.
struct Mark {
    std::string student;
    int stage = 1;
    std::string key;  ///< of all that decides what follows: the file, the suite, the seed
    Verdict verdict = Verdict::missing;
    std::string words;            ///< the compiler's, or ours
    std::string source;           ///< the file's SHA-256
    std::string mistake;          ///< the sentence of the known mistake that it is, if it is one
    std::string smallest;         ///< the smallest failing question, several lines, if one is known
    std::string slice;            ///< its drawing, in the same folder: an SVG
    std::vector<CaseMark> cases;  ///< in the suite's order; none if nothing was judged
    std::optional<PictureMark> picture;
    int most = 0;  ///< the points of all the stage's cases, whether judged or not

    /// Of the cases that passed. None, if these are all given: nothing was written then.
    [[nodiscard]] int points() const;
};

/// In the results: what of the class's folder is nobody's, and why, a line each.
inline constexpr const char* left_over_file = "left_over.txt";

/// "results/students/anna": no student's name is that of a file of ours. Throws InputError if no
/// folder can be called so.
[[nodiscard]] std::filesystem::path student_folder(const std::filesystem::path& results,
                                                   const std::string& student);

/// "results/students/anna/step05_triangle.jsonl"
[[nodiscard]] std::filesystem::path mark_file(const std::filesystem::path& results,
                                              const std::string& student, int stage);

/// Writes the mark whole, or not at all. Throws InputError.
void write_mark(const std::filesystem::path& results, const Mark& mark);

/// Nothing if the file is not there, or is not a whole one of ours.
[[nodiscard]] std::optional<Mark> read_mark(const std::filesystem::path& results,
                                            const std::string& student, int stage);

/// All marks in the folder, by student and stage.
[[nodiscard]] std::vector<Mark> read_marks(const std::filesystem::path& results);

}  // namespace rt::grade
