// The sources of known mistakes and of other right answers.
#pragma once

#include "common/course/authoring/known_mistakes.hpp"

namespace rt {

/// The whole source of a mistake of this suite. Throws InputError if lines are not found, or twice.
[[nodiscard]] std::string source_of(const std::filesystem::path& project, const std::string& suite,
                                    const KnownMistake& mistake);

/// The text of a right answer, in which the sources that it includes stand in place, with the names
/// that its macros give them.
[[nodiscard]] std::string without_included_sources(const std::filesystem::path& project,
                                                   const std::string& text);

}  // namespace rt
