#include "common/course/grade/grade.hpp"

#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"

#include <map>

namespace rt::grade {

namespace {

constexpr std::chrono::minutes time_limit{5};
constexpr const char* templates = "common/course/grade/deploy";

const std::map<std::string, std::vector<std::string>> files_for = {
    {"gradescope", {"setup.sh", "run_autograder"}},
    {"github", {"grade.yml"}},
    {"slurm", {"submit.sh", "grade.sbatch", "report.sbatch", "in_parallel.sh"}},
};

/// A template with the project's folder and the stages in their places.
std::string filled(const fs::path& project, const std::string& name, const std::set<int>& stages) {
    const auto number = [](int stage) { return std::to_string(stage); };
    std::string text = read_text(project / templates / name);
    replace_all(text, "@PROJECT@", shell_word(project.string()));
    replace_all(text, "@STAGES@", stages.empty() ? "" : " --stages " + joined(stages, number, ","));
    return text;
}

/// Writes the files of a place. None of them replaces one that the lecturer has changed.
void write_files(const std::string& place, const fs::path& folder, const fs::path& project,
                 const std::set<int>& stages) {
    std::map<fs::path, std::string> texts;
    for (const std::string& name : files_for.at(place)) {
        const std::string text = filled(project, name, stages);
        const fs::path file = folder / name;
        if (fs::exists(file) && (!fs::is_regular_file(file) || read_text(file) != text))
            throw InputError({file}, "exists already, with other content");
        texts[file] = text;
    }
    for (const auto& [file, text] : texts) {
        write_text(file, text);
        if (!text.starts_with("#!")) continue;
        fs::permissions(file,
                        fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                        fs::perm_options::add);
    }
}

void run(const Command& command) {
    const ProcessResult ending = run_captured(command, time_limit);
    if (ending.status != 0) throw ProgramError("error: " + command[0] + " fails\n" + ending.output);
}

void write_autograder(const fs::path& folder, const fs::path& project,
                      const std::set<int>& stages) {
    const fs::path archive = folder / "autograder.zip";
    if (fs::exists(fs::symlink_status(archive))) throw InputError({archive}, "exists already");
    const TemporaryFolder scratch;
    const fs::path& packed = scratch.path();
    fs::create_directories(packed / "raysteps");
    run({"sh", project / templates / "copy_project.sh", project, packed / "raysteps"});
    write_files("gradescope", packed, project, stages);
    const TemporaryFolder beside(folder);  // an unfinished archive is not left
    const fs::path part = beside.path() / "autograder.zip";
    run({"cmake", "-E", "chdir", packed, "cmake", "-E", "tar", "cf", part, "--format=zip",
         "setup.sh", "run_autograder", "raysteps"});
    fs::rename(part, archive);
}

}  // namespace

void write_for(const std::string& place, const fs::path& place_of_files, const fs::path& project,
               const std::set<int>& stages) {
    if (!files_for.contains(place))
        throw InputError({}, "--for gradescope, github or slurm, not \"" + place + "\"");
    std::error_code error;
    fs::create_directories(place_of_files, error);
    if (error) throw InputError({place_of_files}, "cannot be made: " + error.message());
    const fs::path folder = fs::absolute(place_of_files);  // for tools that start in another folder
    if (place == "gradescope") return write_autograder(folder, project, stages);
    write_files(place, folder, project, stages);
}

}  // namespace rt::grade
