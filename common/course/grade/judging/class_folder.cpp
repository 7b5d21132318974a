#include "common/course/grade/judging/class_folder.hpp"

#include "common/course/grade/judging/archive.hpp"
#include "common/course/grade/judging/source_names.hpp"

#include "common/stages/stages.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/lower_case.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <set>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_name = 80;
// total size of the files unpacked from an archive of a class
constexpr int class_megabytes = 2000;

std::vector<fs::path> entries_of(const fs::path& folder) {
    std::vector<fs::path> all;
    std::error_code failed;
    for (fs::directory_iterator each(folder, failed), end; !failed && each != end;
         each.increment(failed))
        if (!is_litter(each->path().filename())) all.push_back(each->path());
    if (failed) throw InputError({folder}, "cannot be read");
    std::sort(all.begin(), all.end());
    return all;
}

bool is_folder(const fs::path& place) {
    return fs::is_directory(fs::symlink_status(place));
}

/// The stages with a file anywhere in the folder.
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

/// True if the top of the folder contains a stage's file, a stage's folder, or "steps".
bool is_submission(const std::vector<fs::path>& entries) {
    return std::any_of(entries.begin(), entries.end(), [](const fs::path& each) {
        const std::string name = each.filename();
        const Named named = named_for(name);
        return (named.fit >= Fit::near && named.stage != 0 && !label(name)) || name == "steps" ||
               std::find(stage_names.begin(), stage_names.end(), name) != stage_names.end();
    });
}

bool has_labels(const std::vector<fs::path>& entries) {
    return std::any_of(entries.begin(), entries.end(),
                       [](const fs::path& each) { return label(each.filename()).has_value(); });
}

/// True if the folders look like several students': two contain a file of the same stage.
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

/// Creates the names of an archive as folders and files. Only files that may be a student's have
/// contents; the other names are created too, so that no student is lost.
void lay_out(const Unpacked& unpacked, const fs::path& folder) {
    for (const Entry& entry : unpacked.entries) {
        const fs::path name = fs::path(entry.name).lexically_normal();
        if (name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end()) continue;
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

class Finding {
public:
    Finding(const BuildDirectory& workshop, const fs::path& results)
        : workshop_(workshop), results_(results) {}

    void add_place(const fs::path& place) {
        if (fs::is_directory(place))
            add_folder(place);
        else if (fs::is_regular_file(place) && is_archive(place.filename()))
            add_archive(place);
        else
            throw InputError({place}, "is neither a folder nor an archive");
    }

    [[nodiscard]] ClassFolder found() {
        ClassFolder all;
        std::set<std::string> taken;
        for (auto& [key, pieces] : by_student_) {
            std::string student = plain_name(key.second);
            const std::string first = student;
            for (int i = 2; !taken.insert(lower_case(student)).second; ++i)
                student = first + "_" + std::to_string(i);
            if (student != first)
                leave(key.first.has_filename() ? key.first : key.first.parent_path(),
                      "is graded as " + student + ", since there is another " + first);
            all.submissions.push_back({.student = student, .pieces = std::move(pieces)});
        }
        all.left_over = std::move(left_over_);
        return all;
    }

private:
    void add_student(const fs::path& place) {
        const fs::path full = fs::absolute(place).lexically_normal();
        const std::string last =
            full.has_filename() ? full.filename() : full.parent_path().filename();
        if (const std::optional<Labeled> labeled = label(last))
            add_labeled(full, *labeled);
        else
            add_unlabeled(full, last);
    }

    /// The name of an archive is the student's, which no report on anonymous students contains.
    void add_unlabeled(const fs::path& place, const std::string& name) {
        const std::string student = without_archive_ending(name);
        by_student_[{place, student}].push_back(
            {place, "submission" + name.substr(student.size())});
    }

    /// A student may have several files and folders.
    void add_labeled(const fs::path& place, const Labeled& labeled) {
        by_student_[{place.parent_path(), labeled.student}].push_back({place, labeled.name});
        if (labeled.late)
            left_over_.push_back(plain_name(labeled.student) +
                                 ": Canvas marks it LATE; it is graded like the others");
    }

    void add_folder(const fs::path& place) {
        const std::vector<fs::path> entries = entries_of(place);
        const bool labels = has_labels(entries);
        if (label(place.filename()) || (!labels && is_submission(entries))) {
            if (!labels && are_many(entries))
                throw InputError({place},
                                 "has a stage's file, and folders that have one too: is it a class "
                                 "or a submission? --one grades it as one submission; move the "
                                 "file away to grade a class");
            add_student(place);
            return;
        }
        // A single archive may be the whole class.
        const bool alone = 1 == std::count_if(entries.begin(), entries.end(), [](const auto& each) {
                               return is_folder(each) || is_archive(each.filename());
                           });
        for (const fs::path& each : entries)
            if (!(alone && !labels && is_archive(each.filename()) && fs::is_regular_file(each) &&
                  add_class_archive(each)))
                add_entry(each);
    }

    /// Adds one entry of a folder of a class.
    void add_entry(const fs::path& entry) {
        const std::string name = entry.filename();
        std::error_code none;
        if (fs::is_symlink(entry)) return leave(entry, "is a link");
        if (is_folder(entry)) {
            if (fs::equivalent(entry, results_, none)) return;
            if (name[0] == '.' && stages_in(entry).empty()) return leave(entry, "is hidden");
            if (is_results(entry)) return leave(entry, "contains the results of a run");
            return add_student(entry);
        }
        if (const std::optional<Labeled> labeled = label(name))
            return add_labeled(fs::absolute(entry).lexically_normal(), *labeled);
        if (fs::is_regular_file(entry) && is_archive(name)) return add_student(entry);
        leave(entry,
              "is neither a folder nor an archive, and its name is not one by Moodle or Canvas");
    }

    void leave(const fs::path& entry, const std::string& why) {
        std::string name = entry.filename();
        for (char& c : name)
            if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
        left_over_.push_back(name + ": " + why);
    }

    void add_archive(const fs::path& archive) {
        if (label(archive.filename()) || !add_class_archive(archive)) add_student(archive);
    }

    /// Adds the submissions of an archive if it is a class. Not called for a student's own archive
    /// beside others, since it could contain files named as another student's.
    bool add_class_archive(const fs::path& archive) {
        const TemporaryFolder taken_out(workshop_.folder);
        const std::optional<Unpacked> unpacked =
            unpack(workshop_, archive, taken_out.path(), class_megabytes);
        if (!unpacked) return false;
        const fs::path name = make_folder(workshop_.folder, "class.");
        lay_out(*unpacked, name);
        fs::path top = name;
        std::vector<fs::path> entries = entries_of(top);
        while (entries.size() == 1 && is_folder(entries[0]) && !label(entries[0].filename()) &&
               !is_submission(entries)) {
            top = entries[0];
            entries = entries_of(top);
        }
        const auto archives = std::count_if(entries.begin(), entries.end(), [](const auto& each) {
            return !is_folder(each) && is_archive(each.filename());
        });
        const bool labels = has_labels(entries);
        if (!labels && (is_submission(entries) || (archives < 2 && !are_many(entries)))) {
            fs::remove_all(name);
            return false;
        }
        if (!unpacked->whole)
            throw InputError({archive}, "is damaged, or contains more than " +
                                            std::to_string(class_megabytes) +
                                            " MB of submissions: please unpack it yourself");
        for (const fs::path& each : entries) add_entry(each);
        return true;
    }

    const BuildDirectory& workshop_;
    const fs::path& results_;
    // By place and name: for files with a platform's label, the place is their folder.
    std::map<std::pair<fs::path, std::string>, std::vector<Piece>> by_student_;
    std::vector<std::string> left_over_;
};

}  // namespace

ClassFolder find_class(const BuildDirectory& workshop, const std::vector<fs::path>& places,
                       const fs::path& results) {
    Finding finding(workshop, results);
    for (const fs::path& place : places) finding.add_place(place);
    ClassFolder found = finding.found();
    if (found.submissions.empty()) {
        std::string why = "contains no submission";
        for (const std::string& each : found.left_over) why += "; " + each;
        throw InputError({places.at(0)}, why);
    }
    return found;
}

ClassFolder one_submission(const std::vector<fs::path>& places) {
    Submission submission;
    for (const fs::path& place : places) {
        if (!fs::exists(place)) throw InputError({place}, "does not exist");
        const fs::path full = fs::absolute(place).lexically_normal();
        const std::string last =
            full.has_filename() ? full.filename() : full.parent_path().filename();
        if (submission.student.empty())
            submission.student = plain_name(without_archive_ending(last));
        submission.pieces.push_back({full, last});
    }
    return {.submissions = {submission}};
}

std::string plain_name(const std::string& text) {
    std::string name = text;
    for (char& c : name) {
        const bool plain_one = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' ||
                               c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
        if (!plain_one) c = '_';
    }
    if (name.size() > longest_name) {
        name.resize(longest_name);
        // Not in the middle of a character.
        while (!name.empty() && (static_cast<unsigned char>(name.back()) & 0xc0) == 0x80)
            name.pop_back();
        if (!name.empty() && static_cast<unsigned char>(name.back()) >= 0xc0) name.pop_back();
    }
    while (!name.empty() && name.back() == '.') name.pop_back();  // as some file systems do
    if (name.empty() || name.front() == '.' || name.front() == '-') name.insert(0, "_");
    return name;
}

}  // namespace rt::grade
