#include "common/course/grade/intake.hpp"

#include "common/course/files.hpp"

#include "common/input_error.hpp"
#include "common/stages.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <tuple>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_source = 256 * 1024;
constexpr std::size_t longest_name = 80;
constexpr int most_entries = 20000;
constexpr int deepest = 12;

// The longer first, of those that end alike.
constexpr std::array<std::string_view, 8> archive_endings = {
    ".tar.gz", ".tar.xz", ".tar.bz2", ".tar.zst", ".tgz", ".tar", ".zip", ".7z"};

/// The stage whose file is called so; 0 if none is.
int stage_of(const fs::path& file) {
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        if (file.filename() == std::string(stage_name(stage).substr(7)) + ".cpp") return stage;
    return 0;
}

bool is_archive(const fs::path& file) {
    const std::string name = file.filename();
    return std::any_of(
        archive_endings.begin(), archive_endings.end(),
        [&name](std::string_view ending) { return std::string_view(name).ends_with(ending); });
}

/// The text, if the file is one: no link, no device, no pipe, of a size that a person writes.
std::optional<std::string> source_text(const fs::path& file) {
    const int source = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (source == -1) return std::nullopt;
    struct stat about {};
    std::string text(largest_source + 1, '\0');
    const bool is_file = fstat(source, &about) == 0 && S_ISREG(about.st_mode);
    const ssize_t size = is_file ? read(source, text.data(), text.size()) : -1;
    close(source);
    if (size < 0 || std::size_t(size) > largest_source) return std::nullopt;
    text.resize(std::size_t(size));
    return text;
}

/// Whether a folder on the way has this name.
bool is_below(const fs::path& file, const std::string& folder) {
    const fs::path parent = file.parent_path();
    return std::find(parent.begin(), parent.end(), folder) != parent.end();
}

/// The better place first.
auto rank(const fs::path& file) {
    return std::tuple(!is_below(file, "student"), std::distance(file.begin(), file.end()),
                      file.string());
}

/// The files of the thirteen names in the folder, the best of each stage's first, from the folder
/// on.
std::map<int, std::vector<fs::path>> find_files(const fs::path& folder) {
    std::map<int, std::vector<fs::path>> found;
    std::error_code none;
    int left = most_entries;
    for (fs::recursive_directory_iterator each(folder, none), end; !none && each != end && left > 0;
         each.increment(none), --left) {
        if (each.depth() >= deepest) each.disable_recursion_pending();
        const fs::path file = each->path().lexically_relative(folder);
        const bool is_ours = is_below(file, "reference") || is_below(file, "starter") ||
                             is_below(file, "tests") || is_below(file, "build");
        const int stage = stage_of(file);
        if (stage > 0 && !is_ours && !each->is_directory(none)) found[stage].push_back(file);
    }
    for (auto& [stage, files] : found)
        std::sort(files.begin(), files.end(),
                  [](const fs::path& a, const fs::path& b) { return rank(a) < rank(b); });
    return found;
}

HandedIn take_folder(const fs::path& folder) {
    HandedIn handed_in;
    for (const auto& [stage, files] : find_files(folder)) {
        const std::string name = files[0].filename();
        const std::optional<std::string> text = source_text(folder / files[0]);
        if (text)
            handed_in.files[stage] = *text;
        else
            handed_in.words[stage] = name + " is no file of less than 256 KiB.\n";
        const bool differ = std::any_of(files.begin() + 1, files.end(), [&](const fs::path& other) {
            return source_text(folder / other) != text;
        });
        if (differ)
            handed_in.words[stage] += "There are " + std::to_string(files.size()) + " files " +
                                      name + " that differ; the one in " +
                                      files[0].parent_path().string() + "/ was taken.\n";
    }
    return handed_in;
}

/// Those of the archive's names that may be taken out: files of the thirteen names, nowhere but
/// below.
std::vector<std::string> wanted(const std::string& listed) {
    std::vector<std::string> names;
    for (const std::string& name : lines_of(listed)) {
        const fs::path file = name;
        const bool leads_out = file.is_absolute() || name.rfind('-', 0) == 0 ||
                               std::find(file.begin(), file.end(), "..") != file.end();
        if (stage_of(file) > 0 && !leads_out) names.push_back(name);
    }
    return names;
}

HandedIn take_archive(const Workshop& workshop, const fs::path& archive) {
    constexpr std::size_t most_files = 500;
    const TemporaryFolder scratch(workshop.folder);
    const std::string copy = scratch.path() / "archive";
    const TemporaryFolder taken_out(workshop.folder);
    std::error_code failed;
    fs::copy_file(archive, copy, failed);
    if (failed) return {.words_on_all = "The archive cannot be read.\n"};
    fs::permissions(copy, fs::perms(0644));
    fs::permissions(scratch.path(), fs::perms(0755));
    // CMake has all formats, and is there.
    Command tool{RAYSTEPS_CMAKE, "-E", "tar", "tf", copy};
    const Ending listed = run_sealed(workshop, taken_out.path(), {copy, RAYSTEPS_CMAKE_ROOT}, tool);
    if (listed.status != 0) return {.words_on_all = "The archive cannot be opened.\n"};
    const std::vector<std::string> names = wanted(listed.output);
    if (names.empty()) return {};
    if (names.size() > most_files) return {.words_on_all = "The archive has too many files.\n"};
    tool[3] = "xf";
    tool.push_back("--");
    tool.insert(tool.end(), names.begin(), names.end());
    if (run_sealed(workshop, taken_out.path(), {copy, RAYSTEPS_CMAKE_ROOT}, tool).status != 0)
        return {.words_on_all = "The archive cannot be opened.\n"};
    return take_folder(taken_out.path());
}

/// As the name of a folder, in a page, in a table: what is no letter, digit or dot is "_".
std::string plain(std::string name) {
    for (const std::string_view ending : archive_endings)
        if (name.ends_with(ending)) {
            name.erase(name.size() - ending.size());
            break;
        }
    for (char& c : name) {
        const bool plain_one = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ||
                               c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
        if (!plain_one) c = '_';
    }
    if (name.size() > longest_name) name.resize(longest_name);
    if (name.empty() || name.front() == '.' || name.front() == '-') name.insert(0, "_");
    return name;
}

/// A folder of one student's: a file of the thirteen names in it, or a stage's folder, or "steps".
bool is_submission(const fs::path& folder) {
    for (const auto& each : fs::directory_iterator(folder)) {
        const std::string name = each.path().filename();
        if (stage_of(name) > 0 || name == "steps") return true;
        if (std::find(stage_names.begin(), stage_names.end(), name) != stage_names.end())
            return true;
    }
    return false;
}

/// What a run writes, or an earlier one has written: it may lie among the submissions.
bool is_results(const fs::path& folder, const fs::path& results) {
    std::error_code none;
    return fs::equivalent(folder, results, none) ||
           (fs::exists(folder / "seed.txt") && fs::exists(folder / "grades.csv"));
}

void add(const fs::path& place, std::set<std::string>& names, std::vector<Envelope>& found) {
    const fs::path full = fs::absolute(place).lexically_normal();
    const std::string last = full.has_filename() ? full.filename() : full.parent_path().filename();
    const std::string name = plain(last);
    std::string student = name;
    for (int i = 2; !names.insert(student).second; ++i) student = name + "_" + std::to_string(i);
    found.push_back({.student = student, .place = full});
}

}  // namespace

std::vector<Envelope> find_envelopes(const std::vector<fs::path>& places, const fs::path& results) {
    std::vector<fs::path> all;
    for (const fs::path& place : places) {
        const bool is_folder = fs::is_directory(place);
        if (!is_folder && !(fs::is_regular_file(place) && is_archive(place)))
            throw InputError({place}, "is neither a folder nor an archive");
        if (!is_folder || is_submission(place)) {
            all.push_back(place);
            continue;
        }
        for (const auto& each : fs::directory_iterator(place))
            if (!each.is_symlink() && !is_results(each.path(), results) &&
                (each.is_directory() || (each.is_regular_file() && is_archive(each.path()))))
                all.push_back(each.path());
    }
    std::sort(all.begin(), all.end());
    std::set<std::string> names;
    std::vector<Envelope> found;
    for (const fs::path& place : all) add(place, names, found);
    if (found.empty()) throw InputError({places.at(0)}, "holds no submission");
    return found;
}

HandedIn take_in(const Workshop& workshop, const Envelope& envelope) {
    return fs::is_directory(envelope.place) ? take_folder(envelope.place)
                                            : take_archive(workshop, envelope.place);
}

}  // namespace rt::grade
