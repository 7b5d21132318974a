#include "common/course/handout/handout.hpp"

#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"
#include "common/system/whole_file.hpp"

#include <cstdio>
#include <regex>
#include <set>

namespace rt {

namespace {

constexpr std::chrono::minutes update_time_limit{5};
constexpr const char* under_way = "Raysteps, half updated: run ./course update again";

bool is_there(const fs::path& path) {
    return fs::symlink_status(path).type() != fs::file_type::not_found;
}

/// Refuses an incomplete hand-out, and one for another kind of machine.
Manifest read_whole(const fs::path& folder) {
    static const std::regex not_to_touch(
        R"(/.*|(.*/)?\.\.(/.*)?|(build|renders|results)/.*|steps/[^/]*/student[^/]*/.*)");
    Manifest manifest = read_manifest(folder);
    for (const auto& [path, fingerprints] : manifest.fingerprints) {
        if (std::regex_match(path, not_to_touch))
            throw InputError({folder.string()},
                             tr("not a hand-out: it has {path}", {{"path", path}}));
        if (fingerprints.size() != 1 || !manifest.matches(folder, path))
            throw InputError(
                {folder.string()},
                tr("{path} differs from the hand-out: get the hand-out again", {{"path", path}}));
    }
    return manifest;
}

/// The folder of a hand-out, unpacked if necessary.
fs::path unpacked(const fs::path& newer) {
    if (fs::is_directory(newer)) return newer;
    if (newer.empty()) throw InputError({}, tr("update: expected a hand-out, not \"\""));
    if (!fs::exists(newer)) throw InputError({newer.string()}, tr("does not exist"));
    const fs::path folder = build_folder / "newer_handout";
    fs::remove_all(folder);
    fs::create_directories(folder);
    const ProcessResult ending = run_captured(
        {"tar", "-xf", fs::absolute(newer).string(), "-C", folder.string(), "--no-same-owner"},
        update_time_limit);
    if (ending.status != 0) throw InputError({newer.string()}, tr("cannot be unpacked"));
    for (const auto& entry : fs::directory_iterator(folder))
        if (is_handout(entry.path())) return entry.path();
    throw InputError({newer.string()}, tr("contains no hand-out of Raysteps"));
}

class Update {
public:
    Update(const fs::path& newer, Manifest mine, Manifest its)
        : newer_(newer), mine_(std::move(mine)), its_(std::move(its)) {}

    /// Removed files go first: they may be in the way of new ones.
    void run() {
        Manifest both = mine_;
        both.title = under_way;
        for (const auto& [path, fingerprints] : its_.fingerprints)
            both.fingerprints[path].insert(fingerprints.begin(), fingerprints.end());
        remove_left_overs(both);
        write_manifest(project_folder, both);
        for (const auto& [path, fingerprints] : mine_.fingerprints)
            if (its_.fingerprints.count(path) == 0 && is_there(project_folder / path)) drop(path);
        for (const auto& [path, fingerprints] : its_.fingerprints)
            if (!its_.matches(project_folder, path)) bring(path);
        write_manifest(project_folder, its_);
    }

    void explain() const {
        if (changed_.empty())
            print_line(tr("nothing has changed: {title}", {{"title", tr_text(its_.title)}}));
        else
            print_line(tr("{number} files of the hand-out have changed; your own files have not",
                          {{"number", changed_.size()}}));
        for (int stage = 1; stage <= int(stage_names.size()); ++stage)
            if (Workbook(stage).state() != State::untouched && concerns(stage))
                print_line(tr("Check your file again: ./course check {stage}", {{"stage", stage}}));
    }

private:
    /// Removes the files of an update that was killed.
    static void remove_left_overs(const Manifest& manifest) {
        std::set<fs::path> folders;
        for (const auto& [path, fingerprints] : manifest.fingerprints)
            folders.insert((project_folder / path).parent_path());
        std::error_code none;
        for (const fs::path& folder : folders)
            for (const fs::directory_entry& entry : fs::directory_iterator(folder, none))
                if (is_part_file(entry.path())) fs::remove(entry.path(), none);
    }

    void drop(const std::string& path) {
        say(tr("removed"), path);
        if (!mine_.matches(project_folder, path)) return put_aside(path);
        fs::remove(project_folder / path);
        std::error_code not_empty;
        for (fs::path folder = fs::path(path).parent_path(); !folder.empty() && !not_empty;
             folder = folder.parent_path())
            fs::remove(project_folder / folder, not_empty);
    }

    void bring(const std::string& path) {
        const bool known = is_there(project_folder / path);
        say(known ? tr("changed") : tr("new"), path);
        fs::path place;
        for (const fs::path& part : fs::path(path).parent_path()) {
            place /= part;
            if (is_there(project_folder / place) && !fs::is_directory(project_folder / place))
                put_aside(place.string());
        }
        if (known && !mine_.matches(project_folder, path)) put_aside(path);
        copy_whole(newer_ / path, project_folder / path);
    }

    /// A file that differs from the hand-out is the student's work.
    void put_aside(const std::string& path) {
        int number = 1;
        std::string kept;
        do {
            kept = path + ".yours_" + std::to_string(number++);
        } while (is_there(project_folder / kept));
        fs::rename(project_folder / path, project_folder / kept);
        print_line("         " + tr("your old file is kept in {file}", {{"file", kept}}));
    }

    void say(const std::string& what, const std::string& path) {
        std::printf("%-8s %s\n", what.c_str(), path.c_str());
        changed_.push_back(path);
    }

    /// The starter, the hints and the page do not affect a student's file.
    [[nodiscard]] bool concerns(int stage) const {
        const std::string name(stage_name(stage));
        for (const std::string& path : changed_)
            if (path.find(name) != std::string::npos && path.find(".md") == std::string::npos &&
                path.find("/starter/") == std::string::npos)
                return true;
        return false;
    }

    fs::path newer_;
    Manifest mine_;
    Manifest its_;
    std::vector<std::string> changed_;
};

}  // namespace

int update(const fs::path& newer) {
    if (!is_handout(project_folder))
        throw InputError({}, tr("this is not a hand-out: update it with git pull"));
    const fs::path folder = unpacked(newer);
    Manifest mine = read_manifest(project_folder);
    const bool was_interrupted = mine.title == under_way;
    Update update(folder, std::move(mine), read_whole(folder));
    // `course` continues with this copy if the half-updated project does not build.
    if (!was_interrupted || !is_there(build_folder / "updater"))
        copy_whole(build_folder / "course", build_folder / "updater");
    update.run();
    update.explain();
    std::error_code ignored;
    fs::remove_all(build_folder / "newer_handout", ignored);
    return 0;
}

void warn_of_half_update() {
    if (is_handout(project_folder) && read_manifest(project_folder).title == under_way)
        print_error(tr("warning: an update was interrupted: run ./course update again"));
}

}  // namespace rt
