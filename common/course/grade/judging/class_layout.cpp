#include "common/course/grade/judging/class_layout.hpp"

#include "common/course/grade/judging/archive.hpp"
#include "common/course/grade/sandbox/source_names.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <fstream>
#include <map>

namespace rt::grade {

namespace {

/// Creates the names as folders and files.
void create(const Unpacked& unpacked, const fs::path& folder) {
    for (const Entry& entry : unpacked.entries) {
        const fs::path name = fs::path(entry.name).lexically_normal();
        if (name.is_absolute() || std::ranges::find(name, "..") != name.end()) continue;
        const fs::path to = folder / name;
        std::error_code failed;
        if (entry.kind == Entry::Kind::folder) {
            fs::create_directories(to, failed);
            continue;
        }
        fs::create_directories(to.parent_path(), failed);
        // The name may be longer than this system's names.
        if (failed || fs::exists(to, failed) || failed) continue;
        if (entry.kind == Entry::Kind::source || entry.kind == Entry::Kind::archive)
            fs::copy_file(entry.file, to, failed);
        else
            std::ofstream{to};
    }
}

}  // namespace

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> all;
    std::error_code failed;
    for (fs::directory_iterator each(folder, failed), end; !failed && each != end;
         each.increment(failed))
        if (!is_litter(each->path().filename())) all.push_back(each->path());
    if (failed) throw InputError({folder}, "cannot be read");
    std::ranges::sort(all);
    return all;
}

bool is_folder(const fs::path& place) {
    return fs::is_directory(fs::symlink_status(place));
}

std::string last_name(const fs::path& place) {
    const fs::path full = fs::absolute(place).lexically_normal();
    return full.has_filename() ? full.filename() : full.parent_path().filename();
}

std::set<int> stages_in(const fs::path& folder) {
    std::set<int> stages;
    std::error_code failed;
    fs::recursive_directory_iterator each(folder, failed);
    for (const fs::recursive_directory_iterator end; !failed && each != end;
         each.increment(failed)) {
        const Named named = named_for(each->path().filename());
        if (named.fit >= Fit::near && named.stage != 0) stages.insert(named.stage);
    }
    return stages;
}

bool is_submission(const std::vector<fs::path>& entries) {
    return std::ranges::any_of(entries, [](const fs::path& each) {
        const std::string name = each.filename();
        const Named named = named_for(name);
        return (named.fit >= Fit::near && named.stage != 0 && !label(name)) || name == "steps" ||
               std::ranges::find(stage_names, name) != stage_names.end();
    });
}

std::set<fs::path> without_platform(const std::vector<fs::path>& entries) {
    std::map<std::string, std::vector<fs::path>> by_student;
    std::map<std::string, std::set<std::string>> numbers;
    std::size_t archives = 0;
    bool has_late = false;
    for (const fs::path& each : entries) {
        const std::optional<Labeled> labeled = label(last_name(each));
        if (!labeled || labeled->number.empty()) continue;
        by_student[labeled->student].push_back(each);
        numbers[labeled->student].insert(labeled->number);
        archives += is_folder(each) || is_archive(last_name(each)) ? 1 : 0;
        has_late = has_late || labeled->late;
    }
    const bool are_one_student = by_student.size() == 1 && archives > 1 && !has_late;
    std::set<fs::path> all;
    for (const auto& [student, files] : by_student)
        if (are_one_student || numbers[student].size() < files.size())
            all.insert(files.begin(), files.end());
    return all;
}

bool are_many(const std::vector<fs::path>& entries) {
    const std::set<std::string> of_a_project = {"student", "starter", "reference", "src",
                                                "source",  "include", "build",     "tests",
                                                "test",    "code",    "backup",    "old"};
    std::set<int> before;
    for (const fs::path& each : entries) {
        if (!is_folder(each) || of_a_project.count(lower_case(each.filename())) == 1) continue;
        for (const int stage : stages_in(each))
            if (!before.insert(stage).second) return true;
    }
    return false;
}

std::optional<LaidOut> lay_out(const BuildDirectory& workshop, const fs::path& archive,
                               int megabytes) {
    const TemporaryFolder taken_out(workshop.folder);
    const std::optional<Unpacked> unpacked = unpack(workshop, archive, taken_out.path(), megabytes);
    if (!unpacked) return std::nullopt;
    LaidOut laid_out{.folder = make_folder(workshop.folder, "class."), .whole = unpacked->whole};
    create(*unpacked, laid_out.folder);
    std::vector<fs::path>& entries = laid_out.entries;
    entries = entries_of(laid_out.folder);
    while (entries.size() == 1 && is_folder(entries[0]) && !label(entries[0].filename()) &&
           !is_submission(entries)) {
        std::vector<fs::path> inside = entries_of(entries[0]);
        if (is_submission(inside)) break;  // of a single student
        entries = std::move(inside);
    }
    return laid_out;
}

}  // namespace rt::grade
