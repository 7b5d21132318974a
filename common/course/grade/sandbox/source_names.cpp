#include "common/course/grade/sandbox/source_names.hpp"

#include "common/stages/graded_file.hpp"
#include "common/system/suggestion.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <array>
#include <regex>
#include <vector>

namespace rt::grade {

namespace {

// The longer first, of those that end alike.
constexpr std::array<std::string_view, 16> archive_endings = {
    ".tar.gz", ".tar.xz", ".tar.bz2", ".tar.zst", ".tar.z", ".tgz", ".txz", ".tbz2",
    ".tbz",    ".tzst",   ".tar",     ".zipx",    ".zip",   ".7z",  ".rar", ".z"};
constexpr std::array<std::string_view, 5> source_endings = {".cpp", ".cc", ".cxx", ".c++", ".cp"};
// Endings that an editor or a mail program appends to a source.
constexpr std::array<std::string_view, 7> suspect_endings = {".txt",  ".c",   ".h",  ".hpp",
                                                             ".docx", ".rtf", ".pdf"};

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// The start of the tail that editors and copies leave behind the name of a source, "~" of
/// "sphere.cpp~", ".bak", a blank; npos for another name.
std::size_t tail_of(const std::string& name) {
    std::size_t tail = std::string::npos;
    for (const std::string_view ending : source_endings) {
        const std::size_t at = name.rfind(ending);
        if (at == std::string::npos || at + ending.size() == name.size()) continue;
        const char next = name[at + ending.size()];
        if (!is_digit(next) && (next < 'a' || next > 'z')) tail = at + ending.size();
    }
    return tail;
}

/// Letters and digits alone: "soft shadows", "Soft-Shadows" and "soft_shadows" are one.
std::string squeezed(const std::string& text) {
    std::string letters;
    for (const char c : lower_case(text))
        if ((c >= 'a' && c <= 'z') || is_digit(c) || static_cast<unsigned char>(c) >= 0x80)
            letters += c;
    return letters;
}

/// Without a stage's prefix, "step03_", and the suffix of a copy: " (1)", " copy 2".
std::string bare(const std::string& stem) {
    std::string name = squeezed(stem);
    if (name.starts_with("step")) name.erase(0, 4);
    name.erase(0, std::min(name.find_first_not_of("0123456789"), name.size()));
    for (bool found = true; found;) {
        const std::size_t size = name.find_last_not_of("0123456789") + 1;
        found = size < name.size();
        name.resize(size);
        for (const std::string_view copy : {"copy", "copie", "kopie", "final"})
            if (name.size() > copy.size() && name.ends_with(copy)) {
                name.resize(name.size() - copy.size());
                found = true;
            }
    }
    return name;
}

bool is_slip(const std::string& name, const std::string& stem) {
    constexpr std::size_t longest = 40;
    return name.size() < longest && edits(name, stem) <= (stem.size() < 6 ? 1 : 2);
}

/// The stage of "step03_main.cpp"; 0 without a number.
int numbered_stage(const std::string& stem) {
    const std::string name = squeezed(stem);
    if (!name.starts_with("step")) return 0;
    return find_stage(name.substr(4, name.find_first_not_of("0123456789", 4) - 4)).value_or(0);
}

/// The stage whose topic has these letters; nothing for other text.
std::optional<int> stage_with_topic(const std::string& letters) {
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        if (letters == squeezed(topic_of(stage))) return stage;
    return std::nullopt;
}

/// The stage of a main.cpp, "sphere_main.cpp", if it is one.
std::optional<int> trace_stage(const std::string& stem, const std::string& letters) {
    const std::string main = "main";
    if (!letters.ends_with(main)) return std::nullopt;
    const std::string topic = letters.substr(0, letters.size() - main.size());
    if (topic.empty()) return numbered_stage(stem);
    const std::optional<int> stage = stage_with_topic(topic);
    return stage && has_trace(*stage) ? stage : std::nullopt;
}

}  // namespace

Named named_for(const std::string& file_name) {
    const std::string name = lower_case(file_name);
    std::string_view ending = ending_of(name, source_endings);
    if (file_name.ends_with(".C")) ending = ".c";
    const bool source = !ending.empty();
    std::string stem = file_name.substr(0, file_name.size() - ending.size());
    if (!source) {
        ending = ending_of(name, suspect_endings);
        const std::size_t tail = ending.empty() ? tail_of(name) : name.size() - ending.size();
        if (tail == std::string::npos || is_archive(name)) return {};
        stem.resize(tail);
        stem.resize(stem.size() - ending_of(lower_case(stem), source_endings).size());
    }
    const std::string letters = bare(stem);
    if (const std::optional<int> stage = trace_stage(stem, letters)) {
        const bool is_exact = file_name == "main.cpp" ||
                              (has_trace(*stage) && file_name == submitted_name({*stage, true}));
        return {.stage = *stage,
                .fit = is_exact ? Fit::exact
                       : source ? Fit::near
                                : Fit::suspect,
                .is_trace = true};
    }
    Named slip;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        const std::string topic = topic_of(stage);
        if (source && file_name == topic + ".cpp") return {.stage = stage, .fit = Fit::exact};
        if (letters == squeezed(topic))
            return {.stage = stage, .fit = source ? Fit::near : Fit::suspect};
        if (source && slip.stage == 0 && is_slip(letters, squeezed(topic)))
            slip = {.stage = stage, .fit = Fit::suspect};
    }
    return slip;
}

std::optional<int> stage_of_folder(const std::string& folder_name) {
    std::string name = squeezed(folder_name);
    for (const std::string_view word : {"step", "stage"})
        if (name.starts_with(word)) name.erase(0, word.size());
    const std::size_t digits = std::min(name.find_first_not_of("0123456789"), name.size());
    const std::string topic = name.substr(digits);
    return topic.empty() ? find_stage(name) : stage_with_topic(topic);
}

std::optional<Labeled> label(const std::string& name) {
    // The first label in the name is the platform's. What follows it is the student's own name for
    // the file, which may look like another label.
    // doezoe_123_456_sphere.cpp: the student's number, and the file's
    static const std::regex canvas(R"(([^_]+)_(LATE_)?([0-9]+)_([0-9]+)_([\s\S]+))");
    // Zoe Doe_123_assignsubmission_file_, and a file's name after it if there are no folders
    static const std::regex moodle(R"(([\s\S]+?_[0-9]+)_assignsubmission_[a-z]+_?([\s\S]*))");
    std::smatch parts;
    if (std::regex_match(name, parts, canvas))
        return Labeled{.student = parts[1].str() + "_" + parts[3].str(),
                       .name = parts[5],
                       .late = parts[2].matched,
                       .number = parts[4]};
    if (std::regex_match(name, parts, moodle))
        return Labeled{.student = parts[1], .name = parts[2], .number = ""};
    return std::nullopt;
}

bool is_source(const std::string& file_name) {
    return !ending_of(lower_case(file_name), source_endings).empty() || file_name.ends_with(".C");
}

bool is_archive(const std::string& file_name) {
    return !ending_of(lower_case(file_name), archive_endings).empty();
}

std::string without_archive_ending(std::string name) {
    name.resize(name.size() - ending_of(lower_case(name), archive_endings).size());
    return name;
}

bool is_litter(const std::string& file_name) {
    constexpr std::array<std::string_view, 7> litter = {
        "__MACOSX", ".git", ".DS_Store", "Thumbs.db", "desktop.ini", ".svn", ".hg"};
    return file_name.starts_with("._") || std::ranges::find(litter, file_name) != litter.end();
}

}  // namespace rt::grade
