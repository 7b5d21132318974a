// The catalogues tests/mistakes/<suite>.txt: known mistakes, each a change of a right answer.
//
//     mistake far_root_first in textbook
//     origin: seen in student repositories
//     caught by: the unit sphere five ahead is hit at t = 4 (MRT §3)
//     sentence: You take the larger root first. Of two positive ones the smaller is seen (PHY).
//     -    for (const Real t : {(-b - root) / (2 * a), (-b + root) / (2 * a)})
//     +    for (const Real t : {(-b + root) / (2 * a), (-b - root) / (2 * a)})
//
// The right answer is `reference`, `main.cpp`, or one of tests/alternatives/<suite>.cpp. A blank
// line ends a group of lines: those that begin with "-" or " " must be found once in the right
// answer, and those with "+" or " " replace them. A group of new lines only stands at the end of
// the namespace. "in reference around normal": the reference's `normal` is called `correct_normal`.
//
// "// right by_uv around intersect: HAI's u and v" is the first line of a right answer that has
// this function alone: all others are the reference's, whose `intersect` is called
// `correct_intersect`.
#pragma once

#include "common/system/files.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

struct KnownMistake {
    /// Lines of the right answer, and those that replace them. `line` is its first in the
    /// catalogue.
    struct Change {
        std::vector<std::string> old_lines;
        std::vector<std::string> new_lines;
        int line = 0;
    };

    std::string name;
    std::string right_answer;               ///< its file, and its name if the file contains several
    std::string right_text;                 ///< its lines
    std::vector<std::string> right_around;  ///< as in RightAnswer
    std::vector<std::string> around;        ///< functions whose names get "correct_" before them
    std::string origin;
    std::string caught_by;  ///< a case of the suite
    std::string sentence;
    std::vector<Change> changes;
};

/// A right answer beside the reference: a part of tests/alternatives/<suite>.cpp.
struct RightAnswer {
    std::string name;
    std::vector<std::string> around;  ///< the reference's functions in place of which it has others
    std::string text;
};

/// The other right answers of a suite, by name; none without a file.
[[nodiscard]] std::vector<RightAnswer> read_right_answers(const fs::path& project,
                                                          const std::string& suite);

/// One of them, if there is one of that name.
[[nodiscard]] std::optional<RightAnswer> find_right_answer(const fs::path& project,
                                                           const std::string& suite,
                                                           const std::string& name);

/// The catalogue of a suite, "step03_sphere" or "step03_sphere_trace".
[[nodiscard]] std::string catalogue_of(const std::string& suite);

/// The known mistakes of a suite; none without a catalogue. Throws InputError.
[[nodiscard]] std::vector<KnownMistake> read_known_mistakes(const fs::path& project,
                                                            const std::string& suite);

// The sources of known mistakes and of other right answers.

/// The whole source of a mistake of this suite. Throws InputError if lines are not found, or twice.
[[nodiscard]] std::string source_of(const fs::path& project, const std::string& suite,
                                    const KnownMistake& mistake);

/// The whole source of a right answer of this suite.
[[nodiscard]] std::string source_of(const fs::path& project, const std::string& suite,
                                    const RightAnswer& answer);

}  // namespace rt
