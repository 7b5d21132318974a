#include "common/course/grade/judging/intake.hpp"

#include "common/course/grade/judging/archive.hpp"
#include "common/course/grade/sandbox/source_names.hpp"
#include "common/stages/stages.hpp"

#include <unistd.h>

#include <algorithm>
#include <list>
#include <optional>
#include <span>
#include <tuple>

namespace rt::grade {

namespace {

constexpr int most_entries = 1000000;
constexpr int deepest = 60;
constexpr int most_archives = 10;
constexpr int most_megabytes = 32;  // total size of the files unpacked from an archive
constexpr int deepest_archive = 3;
constexpr std::size_t longest_path_shown = 200;  // of a name
constexpr int most_problems = 20;
constexpr std::size_t most_useless = 10000;

/// A student's file whose name is a stage's, or nearly.
struct Found {
    fs::path path;  ///< the path that the student used
    Fit fit = Fit::none;
    std::optional<std::string> text;
    std::string why_not;  ///< the reason without a text: "a link"
};

/// True if a folder of the path has this name.
bool is_below(const fs::path& file, const fs::path& folder) {
    const fs::path parent = file.parent_path();
    return std::ranges::find(parent, folder) != parent.end();
}

/// The stage of the folder nearest to a file that names one; 0 if none does.
int stage_around(const fs::path& file) {
    for (fs::path folder = file.parent_path(); folder.has_relative_path();
         folder = folder.parent_path())
        if (const auto stage = stage_of_folder(folder.filename().string())) return *stage;
    return 0;
}

/// True for files of the project, which are not the student's.
bool is_ours(const fs::path& file, GradedFile graded) {
    const fs::path folder = file.parent_path();
    return is_below(file, "reference") || is_below(file, "starter") ||
           (graded.is_trace && folder.filename() == stage_name(graded.stage) &&
            folder.parent_path().filename() == "steps");
}

/// The better one first.
auto rank(const Found& found) {
    return std::tuple(found.fit != Fit::exact,
                      is_below(found.path, "tests") || is_below(found.path, "build"),
                      !is_below(found.path, "student"),
                      std::distance(found.path.begin(), found.path.end()), found.path.string());
}

/// The name as the student reads it; of a very long one, as archives may contain, the end.
std::string shortened(const fs::path& file) {
    const std::string name = file.string();
    if (name.size() <= longest_path_shown) return name;
    std::size_t start = name.size() - longest_path_shown;
    while (start < name.size() && (static_cast<unsigned char>(name[start]) & 0xc0) == 0x80) ++start;
    return "…" + name.substr(start);
}

/// Searches everything that a student submitted.
class Search {
public:
    explicit Search(const BuildDirectory& workshop) : workshop_(workshop) {}

    void add(const fs::path& place, const fs::path& name, int depth) {
        std::error_code none;
        const fs::file_type type = fs::symlink_status(place, none).type();
        if (type == fs::file_type::directory)
            add_folder(place, name, depth);
        else if (type == fs::file_type::regular && is_archive(name.filename()))
            add_archive(place, name, depth);
        else
            add_file(name, source_text(place),
                     type == fs::file_type::regular ? "more than 256 KiB, or not readable"
                                                    : "a link, or not a regular file");
    }

    [[nodiscard]] SubmittedFiles chosen() {
        SubmittedFiles handed_in;
        for (const auto& [folder, main] : mains_) place_main(folder, main, handed_in);
        for (auto& [graded, found] : found_) choose(graded, found, handed_in);
        std::ranges::sort(others_);
        handed_in.words_on_all = words_;
        if (handed_in.files.empty() && !others_.empty())
            handed_in.words_on_all +=
                "No file has a stage's name. Found: " + listed(others_) + ".\n";
        else if (found_.empty() && mains_.empty() && words_.empty())
            handed_in.words_on_all += no_sources();
        for (auto& [graded, words] : handed_in.words)
            if (handed_in.files.count(graded) == 0) words += handed_in.words_on_all;
        return handed_in;
    }

private:
    /// The reason why nothing was found.
    [[nodiscard]] std::string no_sources() {
        if (useless_.empty()) return "The submission contains no file.\n";
        std::ranges::sort(useless_);
        return "No file is a C++ source. Found: " + listed(useless_) + ".\n";
    }

    void add_folder(const fs::path& folder, const fs::path& name, int depth) {
        std::error_code failed;
        fs::recursive_directory_iterator each(folder, failed);
        std::vector<fs::path> files;
        for (const fs::recursive_directory_iterator end; !failed && each != end;
             each.increment(failed)) {
            const bool is_folder = each->symlink_status(failed).type() == fs::file_type::directory;
            const bool litter =
                is_litter(each->path().filename()) || (is_folder && is_results(each->path()));
            if (is_folder && (litter || each.depth() >= deepest)) each.disable_recursion_pending();
            if (is_folder && each.depth() >= deepest) problem("Folders are too deep.");
            if (is_folder && !litter && access(each->path().c_str(), R_OK | X_OK) != 0) {
                problem("The folder " + shortened(name / each->path().lexically_relative(folder)) +
                        " cannot be read.");
                each.disable_recursion_pending();  // the others are
            }
            if (!is_folder && !litter) files.push_back(each->path());
            if (++entries_ > most_entries) {
                problem("There are more than a million files; not all were searched.");
                break;
            }
        }
        if (failed) problem("Part of the submission cannot be read.");
        std::ranges::sort(files);
        for (const fs::path& file : files) add(file, name / file.lexically_relative(folder), depth);
    }

    void add_archive(const fs::path& archive, const fs::path& name, int depth) {
        const std::string called = shortened(name);
        // One that takes too long is enough.
        if (depth == deepest_archive || ++archives_ > most_archives || !all_whole_) {
            return problem(called + " was not opened: too many archives, or one too large.");
        }
        taken_out_.emplace_back(workshop_.folder);
        const std::optional<Unpacked> unpacked =
            unpack(workshop_, archive, taken_out_.back().path(), most_megabytes);
        if (!unpacked)
            return problem("The archive " + called +
                           " cannot be opened: it is damaged, not readable, or not of a "
                           "supported kind (zip, tar, 7z).");
        all_whole_ = unpacked->whole;
        if (!unpacked->whole)
            problem("The archive " + called + " is damaged, or too large: not all was read.");
        else if (unpacked->entries.empty())
            problem("The archive " + called + " is empty.");
        for (const Entry& entry : unpacked->entries) add_entry(entry, name, depth);
    }

    void add_entry(const Entry& entry, const fs::path& archive, int depth) {
        const fs::path inside = fs::path(entry.name).lexically_normal();
        const fs::path name = archive / inside.relative_path();
        const bool leads_out =
            fs::path(entry.name).is_absolute() || std::ranges::find(inside, "..") != inside.end();
        if (leads_out) return add_file(name, {}, "its name leads out of the archive");
        switch (entry.kind) {
            case Entry::Kind::folder:
                return;
            case Entry::Kind::archive:
                return add_archive(entry.file, name, depth + 1);
            case Entry::Kind::source:
                return add_file(name, source_text(entry.file), "more than 256 KiB");
            case Entry::Kind::other:
                return add_file(name, {}, "");
            case Entry::Kind::link:
                return add_file(name, {}, "a link");
            case Entry::Kind::locked:
                return add_file(name, {}, "it needs a password");
            case Entry::Kind::large:
                return add_file(name, {}, "too large");
            case Entry::Kind::damaged:
                return add_file(name, {}, "damaged");
            case Entry::Kind::nameless:
                return problem("The archive " + shortened(archive) +
                               " contains a file whose name cannot be read.");
        }
    }

    void add_file(const fs::path& name, std::optional<std::string> text, std::string why_not) {
        const std::string file = name.filename();
        auto [stage, fit, is_trace] = named_for(file);
        if (is_trace && stage == 0) stage = stage_around(name);
        if (is_trace && stage != 0 && !has_trace(stage)) return;
        if (stage == 0) {
            if (!why_not.empty() && is_archive(file))
                problem("The archive " + shortened(name) + " was not opened: " + why_not + ".");
            else if (is_source(file))
                others_.push_back(shortened(name));
            else if (useless_.size() < most_useless)
                useless_.push_back(shortened(name));
            if (is_trace && text)
                mains_.emplace_back(name.parent_path(),
                                    Found{.path = name, .fit = fit, .text = std::move(text)});
            return;
        }
        // A stage's own header is in every copy of the project.
        if (file == topic_of(stage) + ".hpp" && name.parent_path().filename() == stage_name(stage))
            return;
        Found found{.path = name, .fit = fit, .why_not = std::move(why_not)};
        const GradedFile graded(stage, is_trace);
        if (is_ours(name, graded))
            found.why_not = "a file of the project, not yours";
        else if (fit == Fit::suspect)
            found.why_not = "its name is not a stage's";
        else
            found.text = std::move(text);
        std::vector<Found>& all = found_[graded];
        // An archive may contain a name twice: the last entry counts, as in every unpacker.
        const auto twice = std::ranges::find_if(all, [&](const Found& other) {
            return other.path == found.path && other.text && found.text;
        });
        if (twice != all.end())
            *twice = std::move(found);
        else
            all.push_back(std::move(found));
    }

    /// A main.cpp that no folder names a stage of: it belongs to the stage with a file beside it,
    /// if it is one.
    void place_main(const fs::path& folder, const Found& main, SubmittedFiles& handed_in) {
        std::vector<int> stages;
        for (const auto& [graded, files] : found_)
            if (!graded.is_trace && has_trace(graded.stage) &&
                std::ranges::any_of(files, [&](const Found& each) {
                    return each.text && each.path.parent_path() == folder;
                }))
                stages.push_back(graded.stage);
        if (stages.size() == 1) found_[{stages[0], true}].push_back(main);
        const bool is_of_project = is_below(main.path, "common") || is_below(main.path, "tests");
        if (stages.empty() && !is_of_project)
            problem(shortened(main.path) +
                    " is not used: no folder of it, and no file beside it, has a stage's name. A "
                    "name for that of stage 3 is " +
                    submitted_name({3, true}) + ".");
        if (stages.size() < 2) return;
        for (const int stage : stages)
            handed_in.words[{stage, true}] = shortened(main.path) +
                                             " is beside the files of several stages: a name for "
                                             "this one would be " +
                                             submitted_name({stage, true}) + ".\n";
    }

    /// Adds a sentence for the student. A hostile archive would cause thousands.
    void problem(const std::string& sentence) {
        ++problems_;
        if (problems_ <= most_problems) words_ += sentence + "\n";
        if (problems_ == most_problems + 1) words_ += "There were more problems like these.\n";
    }

    static void choose(GradedFile graded, std::vector<Found>& found, SubmittedFiles& handed_in) {
        std::ranges::sort(found, {}, rank);
        const std::string name = file_name(graded);
        const auto best =
            std::ranges::find_if(found, [](const Found& each) { return each.text.has_value(); });
        std::string words;
        if (best == found.end()) {
            std::vector<std::string> not_taken;
            for (const Found& each : found)
                not_taken.push_back(shortened(each.path) + " (" + each.why_not + ")");
            handed_in.words[graded] =
                "There is no " + name + ". Found, but not used: " + listed(not_taken) + ".\n";
            return;
        }
        handed_in.files[graded] = *best->text;
        if (best->fit != Fit::exact)
            words += shortened(best->path) + " was used as " + name + ".\n";
        std::vector<std::string> differ;
        for (const Found& each : found)
            if (each.text && each.text != best->text) differ.push_back(shortened(each.path));
        if (!differ.empty())
            words += "There are " + std::to_string(differ.size() + 1) + " files for " + name +
                     " that differ; " + shortened(best->path) + " was used, and not " +
                     listed(differ) + ".\n";
        if (!words.empty()) handed_in.words[graded] = words;
    }

    const BuildDirectory& workshop_;
    std::list<TemporaryFolder> taken_out_;
    std::map<GradedFile, std::vector<Found>> found_;
    std::vector<std::pair<fs::path, Found>> mains_;  ///< by folder: the main.cpp of unknown stages
    std::vector<std::string> others_;                ///< sources of no stage's name
    std::vector<std::string> useless_;               ///< files that are no source
    std::string words_;
    int problems_ = 0;
    int entries_ = 0;
    int archives_ = 0;
    bool all_whole_ = true;
};

}  // namespace

std::string listed(const std::vector<std::string>& names) {
    constexpr std::size_t most = 6;
    if (names.size() <= most) return joined(names);
    return joined(std::span(names).first(most)) + " and " + std::to_string(names.size() - most) +
           " more";
}

bool is_results(const fs::path& folder) {
    std::error_code none;
    return fs::is_directory(folder / "students", none) &&
           (fs::exists(folder / "grades.csv", none) || !files_in(folder, ".lock.1").empty() ||
            fs::exists(folder / "seed.txt", none));
}

SubmittedFiles take_in(const BuildDirectory& workshop, const Submission& submission) {
    Search search(workshop);
    for (const Piece& piece : submission.pieces) {
        // The folder's own name means nothing to the student. A place that the lecturer named may
        // be a link.
        if (fs::is_directory(piece.place))
            search.add(fs::canonical(piece.place), "", 0);
        else
            search.add(piece.place, piece.name, 0);
    }
    return search.chosen();
}

}  // namespace rt::grade
