#include "common/course/handout/live_links.hpp"

namespace rt {

namespace {

namespace fs = std::filesystem;

/// True for the path of a missing file, with a folder. Anything else may be code: `[&](int i)`.
bool leads_nowhere(const std::string& address, const fs::path& folder) {
    const std::string file = address.substr(0, address.find('#'));
    return file.find('/') != std::string::npos && file.find("://") == std::string::npos &&
           file.find_first_of(" ,;\n") == std::string::npos && !fs::exists(folder / file);
}

}  // namespace

std::string with_live_links(const std::string& page, const fs::path& folder) {
    std::string text;
    std::size_t done = 0;
    for (std::size_t middle = page.find("]("); middle != std::string::npos;
         middle = page.find("](", middle + 2)) {
        const std::size_t start = page.substr(0, middle).find_last_of("[]");
        const std::size_t end = page.find(')', middle);
        if (start == std::string::npos || page[start] != '[' || end == std::string::npos) continue;
        if (!leads_nowhere(page.substr(middle + 2, end - middle - 2), folder)) continue;
        text += page.substr(done, start - done) + page.substr(start + 1, middle - start - 1);
        done = end + 1;
    }
    return text + page.substr(done);
}

}  // namespace rt
