#include "common/course/grade/judging/class_folder.hpp"

#include "common/course/grade/judging/class_layout.hpp"
#include "common/course/grade/sandbox/source_names.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace rt::grade {

namespace {

constexpr std::size_t longest_name = 80;
// total size of the files unpacked from an archive of a class
constexpr int class_megabytes = 2000;
// and from a student's, to see whether it looks like one
constexpr int submission_megabytes = 32;

class Finding {
public:
    Finding(const BuildDirectory& workshop, const fs::path& results, bool archives_are_classes)
        : workshop_(workshop), results_(results), archives_are_classes_(archives_are_classes) {}

    /// The entries of a folder, or the lecturer's places: whose labels are a platform's.
    void look_at(const std::vector<fs::path>& entries) {
        as_named_.merge(without_platform(entries));
    }

    void add_place(const fs::path& place) {
        places_.push_back({place});
        if (fs::is_directory(place))
            add_folder(place);
        else if (fs::is_regular_file(place) && is_archive(place.filename()))
            add_archive(place);
        else
            throw InputError({place}, "is neither a folder nor an archive");
    }

    [[nodiscard]] ClassFolder found() {
        ClassFolder all;
        std::map<Key, std::string> names;
        std::map<std::string, std::string> taken;  // by the name without capitals
        for (auto& [key, pieces] : by_student_) {
            const std::string first = plain_name(key.second);
            std::string student = first;
            for (int i = 2; !taken.emplace(lower_case(student), student).second; ++i)
                student = first + "_" + std::to_string(i);
            const std::string other = taken.at(lower_case(first));
            if (student != first)
                leave(key.first.has_filename() ? key.first : key.first.parent_path(),
                      "is graded as " + student + ", since there is " +
                          (other == first ? "another " : "") + other);
            all.submissions.push_back({.student = student, .pieces = std::move(pieces)});
            names[key] = student;
        }
        for (const Place& place : places_) {
            all.taken_as.push_back(taken_as(place, names));
            if (!place.is_class) continue;
            for (const Key& key : place.students) all.classes[place.path].push_back(names.at(key));
        }
        all.left_over = std::move(left_over_);
        return all;
    }

private:
    /// The place and the name of a student: for files with a platform's label, the place is their
    /// folder.
    using Key = std::pair<fs::path, std::string>;

    /// A place that the lecturer has named.
    struct Place {
        fs::path path;
        bool is_class = false;
        std::set<Key> students;
        std::string doubt;  ///< an archive that looks like a class
    };

    [[nodiscard]] static std::string taken_as(const Place& place,
                                              const std::map<Key, std::string>& names) {
        std::vector<std::string> students;
        for (const Key& key : place.students) students.push_back(names.at(key));
        const std::string taken = place.path.string() + " is taken as ";
        if (!place.is_class) return taken + "one submission, of " + listed(students) + place.doubt;
        const bool may_be_one = students.size() < 3 && place.doubt.empty();
        return taken + "a class of " + std::to_string(students.size()) + ": " + listed(students) +
               (may_be_one ? "; --one takes it as one submission" : "") + place.doubt;
    }

    void add(const Key& key, const Piece& piece) {
        by_student_[key].push_back(piece);
        places_.back().students.insert(key);
    }

    /// Returns the parts of a name that Moodle or Canvas wrote; nothing for any other name.
    [[nodiscard]] std::optional<Labeled> label_of(const fs::path& place) const {
        return as_named_.contains(place) ? std::nullopt : label(last_name(place));
    }

    [[nodiscard]] bool has_labels(const std::vector<fs::path>& entries) const {
        return std::ranges::any_of(
            entries, [this](const fs::path& each) { return label_of(each).has_value(); });
    }

    void add_student(const fs::path& place) {
        const fs::path full = fs::absolute(place).lexically_normal();
        if (const std::optional<Labeled> labeled = label_of(place))
            add_labeled(full, *labeled);
        else
            add_unlabeled(full, last_name(place));
    }

    /// The name of an archive is the student's, which no report on anonymous students contains.
    void add_unlabeled(const fs::path& place, const std::string& name) {
        const std::string student = without_archive_ending(name);
        add({place, student}, {place, "submission" + name.substr(student.size())});
    }

    [[nodiscard]] static bool is_whole(const fs::path& place) {
        return is_folder(place) || is_archive(place.filename());
    }

    /// A student may have several files and folders.
    void add_labeled(const fs::path& place, const Labeled& labeled) {
        const auto before = by_student_.find({place.parent_path(), labeled.student});
        if (!labeled.number.empty() && before != by_student_.end())
            for (const Piece& each : before->second)
                if (is_whole(each.place) && is_whole(place))
                    left_over_.push_back(plain_name(labeled.student) + ": " +
                                         one_line(each.place.filename().string()) + " and " +
                                         one_line(place.filename().string()) +
                                         " are graded as one submission, by their numbers");
        add({place.parent_path(), labeled.student}, {place, labeled.name});
        if (labeled.late)
            left_over_.push_back(plain_name(labeled.student) +
                                 ": Canvas marks it LATE; it is graded like the others");
    }

    void add_folder(const fs::path& place) {
        const std::vector<fs::path> entries = entries_of(place);
        look_at(entries);
        const bool labels = has_labels(entries);
        if (!archives_are_classes_ && (label_of(place) || (!labels && is_submission(entries)))) {
            if (!labels && are_many(entries))
                throw InputError({place},
                                 "has a stage's file, and folders that have one too: is it a class "
                                 "or a submission? --one grades it as one submission; move the "
                                 "file away to grade a class");
            add_student(place);
            return doubt(place);
        }
        places_.back().is_class = true;
        const bool alone = 1 == std::ranges::count_if(entries, [](const auto& each) {
                               return is_folder(each) || is_archive(each.filename());
                           });
        for (const fs::path& each : entries) {
            const bool is_only_archive = alone && !labels && is_archive(each.filename()) &&
                                         fs::is_regular_file(fs::symlink_status(each));
            if (is_only_archive && archives_are_classes_) {
                add_class_archive(each);
                continue;
            }
            const std::size_t before = places_.back().students.size();
            add_entry(each);
            const bool is_student = places_.back().students.size() > before;
            if (is_only_archive || (is_student && is_folder(each) && !labels)) doubt(each);
        }
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
        if (const std::optional<Labeled> labeled = label_of(entry))
            return add_labeled(fs::absolute(entry).lexically_normal(), *labeled);
        if (fs::is_regular_file(entry) && is_archive(name)) return add_student(entry);
        leave(entry,
              "is neither a folder nor an archive, and its name is not one by Moodle or Canvas");
    }

    void leave(const fs::path& entry, const std::string& why) {
        left_over_.push_back(one_line(entry.filename().string()) + ": " + why);
    }

    void add_archive(const fs::path& archive) {
        if (label_of(archive)) return add_student(archive);
        if (archives_are_classes_) return add_class_archive(archive);
        add_student(archive);
        doubt(archive);
    }

    /// Adds the submissions in an archive, which the lecturer has called a class. A student's own
    /// archive may contain files named as another student's.
    void add_class_archive(const fs::path& archive) {
        places_.back().is_class = true;
        const std::optional<LaidOut> found = lay_out(workshop_, archive, class_megabytes);
        if (!found || !found->whole)
            throw InputError({archive}, "is damaged, or contains more than " +
                                            std::to_string(class_megabytes) +
                                            " MB of submissions: please unpack it yourself");
        look_at(found->entries);
        if (!has_labels(found->entries) && is_submission(found->entries))
            throw InputError({archive},
                             "has a stage's file at its top: it is one submission, and "
                             "no class");
        for (const fs::path& each : found->entries) add_entry(each);
    }

    /// Remarks that a student's archive or folder looks like a class.
    void doubt(const fs::path& place) try {
        if (is_folder(place)) {
            std::vector<fs::path> entries = entries_of(place);
            while (entries.size() == 1 && is_folder(entries[0])) entries = entries_of(entries[0]);
            const std::string students = students_in(place, entries);
            if (!students.empty()) places_.back().doubt += students + ", if you name it alone";
        } else if (const auto found = lay_out(workshop_, place, submission_megabytes)) {
            const std::string students = students_in(place, found->entries);
            if (!students.empty()) places_.back().doubt += students + ", which --class would grade";
            fs::remove_all(found->folder);
        }
    } catch (const Interrupted&) {
        throw;
    } catch (const std::exception&) {
        // Its grading reports the reason.
    }

    /// "; week1.zip looks like a class of 2, anna, bob", or nothing.
    [[nodiscard]] std::string students_in(const fs::path& place,
                                          const std::vector<fs::path>& entries) const {
        const auto archives = std::ranges::count_if(entries, [](const auto& each) {
            return !is_folder(each) && is_archive(each.filename());
        });
        Finding inside(workshop_, results_, false);
        inside.look_at(entries);
        inside.places_.push_back({place});
        if (inside.has_labels(entries) ||
            (!is_submission(entries) && (archives > 1 || are_many(entries))))
            for (const fs::path& each : entries) inside.add_entry(each);
        std::vector<std::string> students;
        for (const Submission& each : inside.found().submissions) students.push_back(each.student);
        return students.empty() ? ""
                                : "; " + place.filename().string() + " looks like a class of " +
                                      std::to_string(students.size()) + ", " + listed(students);
    }

    const BuildDirectory& workshop_;
    const fs::path& results_;
    bool archives_are_classes_;
    std::map<Key, std::vector<Piece>> by_student_;
    std::vector<Place> places_;
    std::vector<std::string> left_over_;
    std::set<fs::path> as_named_;  ///< whose names are no platform's, though they look so
};

}  // namespace

ClassFolder find_class(const BuildDirectory& workshop, const std::vector<fs::path>& places,
                       const fs::path& results, bool archives_are_classes) {
    Finding finding(workshop, results, archives_are_classes);
    finding.look_at(places);
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
        const std::string last = last_name(place);
        const std::optional<Labeled> labeled = label(last);
        if (submission.student.empty())
            submission.student =
                plain_name(labeled ? labeled->student : without_archive_ending(last));
        submission.pieces.push_back({full, labeled ? labeled->name : last});
    }
    const auto text = [](const fs::path& place) { return place.string(); };
    return {.submissions = {submission},
            .taken_as = {joined(places, text) + (places.size() == 1 ? " is" : " are") +
                         " taken as one submission, of " + submission.student}};
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
