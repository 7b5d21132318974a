// The files of a hand-out, and the parts that a lecturer leaves out of it.
#pragma once

#include "common/system/files.hpp"

#include <set>
#include <string>

namespace rt {

/// How much of the help, and which of the stages, students get.
struct Selection {
    std::set<int> stages;  ///< empty: all
    int hints = 3;         ///< levels of hints: 0 to 3
    bool answers = true;   ///< to the questions of the pages
    std::string language;  ///< of the pages and of ./course: "fr"; empty for English pages
};

/// Reads "1-5,9" into the selection. Throws InputError if these are no stages.
void select_stages(Selection& selection, const std::string& stages);

/// Sets the language. Throws InputError if the project has no pages in it, or without po4a.
void select_language(Selection& selection, const std::string& language);

/// False for the page, the hints and the starter of a stage that is left out. Its program, scene
/// and suite stay: they are made of references.
[[nodiscard]] bool is_selected(const Selection& selection, const std::string& path);

/// The text of a page or of hints, without what is left out.
[[nodiscard]] std::string selected_text(const Selection& selection, const std::string& path,
                                        const std::string& text);

/// The entries of a translation's catalogue whose English text is in the page, and its header.
[[nodiscard]] std::string selected_entries(const std::string& catalogue, const std::string& page);

/// True if students get the file at this path of the project. Whatever is not named in the list of
/// rooms and folders stays out.
[[nodiscard]] bool is_for_students(const std::string& path);

/// The page with the text alone in place of each Markdown link to a file that does not exist, as
/// seen from the page's folder. Links to other hosts and into the page itself stay.
[[nodiscard]] std::string with_live_links(const std::string& page, const fs::path& folder);

}  // namespace rt
