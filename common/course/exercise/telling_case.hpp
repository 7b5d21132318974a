// The failing case that tells a student most, chosen by what known mistakes fail.
#pragma once

#include "common/course/build/suite_report.hpp"
#include "common/system/files.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace rt {

/// A known mistake, what it fails, and the case that its author names for it.
struct KnownFailure {
    std::string mistake;
    std::set<std::string> failures;  ///< names of cases; of `trace`, digests of questions
    std::string caught_by;
};

/// What is known of a stage's cases.
struct KnownCases {
    std::vector<KnownFailure> mistakes;                  ///< in its functions and in `trace`
    std::map<std::string, std::set<std::string>> calls;  ///< by case: the functions that it calls
};

/// Where the known mistakes are, from the project's folder.
inline constexpr const char* mistakes_folder = "tests/mistakes";

/// The folder with what a hand-out has of the catalogues in this one.
[[nodiscard]] fs::path in_handout(const fs::path& mistakes);

/// The lines of a catalogue that name a mistake and the case that catches it.
[[nodiscard]] std::string authors_cases(const std::string& catalogue);

/// Reads probes.txt and trace.txt in the folder <mistakes>/<stage>, and the catalogues <stage>.txt
/// and <stage>_trace.txt beside it, or in_handout. Empty without these files.
[[nodiscard]] KnownCases known_cases(const fs::path& mistakes, const std::string& stage);

/// The part to look at first: the first with a failing case that no wrong function of another part
/// explains. A function is wrong if a failing case calls no other one. Empty if no case fails.
[[nodiscard]] std::string part_to_mend(const std::vector<CaseResult>& cases,
                                       const KnownCases& known);

/// The index of the case to explain first, among the failing cases of the part: the case that their
/// authors name for the recognized mistakes, if there are some. Else each known mistake votes for
/// its case, with the more weight the more of its failures are the student's, too; without votes,
/// the case wins that the fewest known mistakes fail. Fixed cases come before random ones, and
/// whole pictures are last. The number of cases if none fails.
[[nodiscard]] std::size_t most_telling(const std::vector<CaseResult>& cases,
                                       const std::string& part,
                                       const std::vector<std::string>& recognized,
                                       const KnownCases& known);

/// The index of the first failing case of the part: of a function that is not written, the
/// plainest.
[[nodiscard]] std::size_t first_failing(const std::vector<CaseResult>& cases,
                                        const std::string& part);

/// The other parts that fail and may fail because of this one: known mistakes fail cases of both,
/// or a case of theirs calls its functions.
[[nodiscard]] std::vector<std::string> parts_that_use(const std::string& part,
                                                      const std::vector<CaseResult>& cases,
                                                      const KnownCases& known);

}  // namespace rt
