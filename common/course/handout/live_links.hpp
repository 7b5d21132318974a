// Links in the pages of a hand-out.
#pragma once

#include <filesystem>
#include <string>

namespace rt {

/// The page with the text alone in place of each Markdown link to a file that does not exist, as
/// seen from the page's folder. Links to other hosts and into the page itself stay.
[[nodiscard]] std::string with_live_links(const std::string& page,
                                          const std::filesystem::path& folder);

}  // namespace rt
