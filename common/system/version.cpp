#include "common/system/version.hpp"

#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <fstream>

namespace rt {

namespace {

constexpr std::size_t short_commit = 7;

/// The first line; empty if there is none.
std::string first_line(const fs::path& file) {
    std::ifstream in(file);
    std::string line;
    std::getline(in, line);
    return line;
}

/// The commit of a reference, from the list in which git packs older ones.
std::string packed_commit(const fs::path& file, const std::string& reference) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);)
        if (line.ends_with(" " + reference)) return line;
    return "";
}

/// The commit in the title of a hand-out (common/course/handout), "Raysteps, version 1.0.0
/// (52c7ed4), handed out …"; empty if it has none.
std::string commit_of_handout(const std::string& title) {
    const std::string version = title.substr(0, title.find(", handed out"));
    const std::size_t open = version.find(" (");
    if (open == std::string::npos || !version.ends_with(')')) return "";
    return version.substr(open + 2, version.size() - open - 3);
}

/// The commit that is checked out, as git's files state it; empty if there are none.
std::string commit_of(const fs::path& project) {
    const std::string title = first_line(project / "steps/handout.txt");
    if (!title.empty()) return commit_of_handout(title);
    const fs::path git = project / ".git";
    const std::string head = first_line(git / "HEAD");
    const std::string link = "ref: ";
    if (!head.starts_with(link)) return head;
    const std::string reference = head.substr(link.size());
    const std::string commit = first_line(git / reference);
    return commit.empty() ? packed_commit(git / "packed-refs", reference) : commit;
}

}  // namespace

std::string version_number() {
    return RAYSTEPS_VERSION;
}

std::string version(const fs::path& project) {
    const std::string commit = commit_of(project).substr(0, short_commit);
    return version_number() + (commit.empty() ? "" : " (" + commit + ")");
}

std::string today() {
    const char* given = std::getenv("SOURCE_DATE_EPOCH");
    const std::time_t now = given == nullptr ? std::time(nullptr) : std::atoll(given);
    char text[16] = "";
    if (const std::tm* const day = std::localtime(&now))
        std::strftime(text, sizeof text, "%F", day);
    return text;
}

}  // namespace rt
