// A lecturer's settings for a class: the file term.txt in the results.
// docs/reference/instructors.md has an example.
#pragma once

#include "common/course/grade/results/csv.hpp"
#include "common/course/grade/results/results.hpp"
#include "common/course/grade/results/roster.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rt::grade {

/// Points that the lecturer sets, or adds.
struct PointsByHand {
    double points = 0;
    std::string comment;
    bool excused = false;  ///< the stage counts neither for nor against the student
};

/// The submission of another student of the group.
struct Shared {
    std::string student;  ///< whose folder has the marks
    std::string group;
};

struct Term {
    static constexpr int total = 0;  ///< the key of the total among the stages of overrides

    std::optional<Roster> roster;
    StudentNames names;             ///< in the results and on the roster
    std::map<int, double> weights;  ///< by stage; 1 if not listed
    std::map<int, bool> bonus;      ///< stages whose points are a bonus
    double late_percent = 0;        ///< of the points, per day
    std::map<std::string, double> days_late;
    std::map<std::pair<std::string, int>, PointsByHand> overrides;
    std::map<std::string, std::vector<PointsByHand>> additions;
    double additions_of = 0;  ///< the points that additions can have: a part of the maximum
    std::map<std::string, Shared> shared;  ///< by student without a submission
    std::set<std::string> groups;          ///< submissions with the name of a group
    double out_of = 0;       ///< the uploaded totals are scaled to this maximum; 0 for no scaling
    bool anonymous = false;  ///< public reports have numbers instead of names
    std::uint64_t key = 0;   ///< the key of these numbers
    std::string language;    ///< of the reports: "fr"; empty for English
    FileLocation language_place;
    std::vector<std::string> notes;  ///< on lines of these files that fit no student or no stage

    [[nodiscard]] double weight(int stage) const;
    [[nodiscard]] bool is_excused(const std::string& student, int stage) const;
    /// "s-3f07a2c1" if anonymous; else the student's name.
    [[nodiscard]] std::string called(const std::string& student) const;
};

/// Reads results/term.txt and the files that it names; returns a term without settings if it does
/// not exist. A student is identified by the name in the results, or by the number or name on the
/// roster. `others` have a submission without marks yet. Throws InputError.
[[nodiscard]] Term read_term(const fs::path& results, const std::vector<Mark>& marks,
                             const Students& others = {});

// The lines "word: value" of a lecturer's term.txt.

struct Settings {
    struct Word {
        std::string value;
        int line = 0;
    };
    fs::path file;
    std::map<std::string, Word> words;  ///< all that may be there once
    std::map<int, double> weights;      ///< by stage
    std::map<int, bool> bonus;

    [[nodiscard]] FileLocation place(const std::string& word) const;

    /// The number of a setting, from 0 to `most`; 0 if it is not there. Throws InputError.
    [[nodiscard]] double number(const std::string& word, double most) const;

    /// The table that a setting names, beside this file; nothing if there is no such setting.
    /// Throws InputError.
    [[nodiscard]] std::optional<Csv> table(const std::string& word) const;
};

/// Throws InputError with the line.
[[nodiscard]] Settings read_settings(const fs::path& file);

/// Throws InputError for other text.
[[nodiscard]] double read_number(const std::string& text, const FileLocation& place, double least,
                                 double most);

/// "5" and "triangle". Throws InputError.
[[nodiscard]] int read_stage(const std::string& text, const FileLocation& place);

}  // namespace rt::grade
