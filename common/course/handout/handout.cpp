#include "common/course/handout/handout.hpp"

#include "common/course/book/site.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/project.hpp"
#include "common/course/handout/for_students.hpp"
#include "common/course/handout/manifest.hpp"
#include "common/system/files.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <version>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::minutes time_limit{5};
constexpr const char* archive_ending = ".tar.gz";

/// The output of git ls-files; nothing if the project is not a clone.
std::vector<std::string> ask_git(const std::string& options) {
    const fs::path answer = build_folder / "handout.files";
    const std::string root = project_folder.string();
    const std::string question =
        "git -C \"$1\" -c safe.directory=\"$1\" ls-files -z " + options + " > \"$2\"";
    const ProcessResult ending =
        run_captured({"sh", "-c", question, "git", root, answer.string()}, time_limit);
    std::vector<std::string> paths;
    if (ending.status != 0) return paths;
    std::istringstream in(read_text(answer));
    for (std::string path; std::getline(in, path, '\0');)
        if (is_for_students(path) && fs::is_regular_file(project_folder / path))
            paths.push_back(path);
    return paths;
}

/// The files of a folder and of those in it, by their paths from there.
std::vector<std::string> all_files(const fs::path& folder) {
    std::vector<std::string> paths;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file())
            paths.push_back(entry.path().lexically_relative(folder).string());
    return paths;
}

/// The existing files, for a project outside git.
std::vector<std::string> look_around() {
    std::vector<std::string> paths;
    for (const auto& entry : fs::directory_iterator(project_folder)) {
        const std::string name = entry.path().filename().string();
        if (entry.is_regular_file()) paths.push_back(name);
    }
    for (const std::string folder : {"common", "docs", "scenes", "steps", "tests"})
        for (const std::string& path : all_files(project_folder / folder))
            paths.push_back((folder + "/").append(path));
    const auto not_theirs = [](const std::string& path) { return !is_for_students(path); };
    paths.erase(std::remove_if(paths.begin(), paths.end(), not_theirs), paths.end());
    return paths;
}

std::vector<std::string> files_for_students() {
    const std::vector<std::string> known = ask_git("");
    if (known.empty()) return look_around();
    for (const std::string& path : ask_git("--others --exclude-standard"))
        std::fprintf(stderr, "warning: %s is not in git, and left out\n", path.c_str());
    return known;
}

#if defined(__x86_64__)
constexpr const char* machine = "__x86_64__";
#elif defined(__aarch64__)
constexpr const char* machine = "__aarch64__";
#else
constexpr const char* machine = "";  // for a project that is not a hand-out
#endif

/// A source that compiles only where the references' objects can be linked. Its first line states
/// this in English.
std::string fits() {
    utsname system{};
    uname(&system);
    std::string text;
#ifdef _GLIBCXX_RELEASE
    const std::string release = std::to_string(_GLIBCXX_RELEASE);
    text = "// g++ " + release + " or newer, or clang++ with its library, on " + system.sysname +
           " " + system.machine + "\n#include <version>\n" +
           "static_assert(_GLIBCXX_RELEASE >= " + release +
           " && _GLIBCXX_USE_CXX11_ABI == " + std::to_string(_GLIBCXX_USE_CXX11_ABI) + ");\n";
#else
    text = std::string("// clang++ with libc++, on ") + system.sysname + " " + system.machine +
           "\n#include <version>\nstatic_assert(_LIBCPP_VERSION > 0);\n";
#endif
    return text + "static_assert(" + machine +
           " && sizeof(void*) == " + std::to_string(sizeof(void*)) + ");\nint main() {}\n";
}

std::string today() {
    const std::time_t time = std::time(nullptr);
    char text[] = "2026-11-21";
    std::strftime(text, sizeof text, "%Y-%m-%d", std::localtime(&time));
    return text;
}

/// The pages of the hand-out as a site, if that of the clone was built once.
void add_book(const fs::path& folder) {
    if (!fs::exists(project_folder / site_of_clone)) {
        std::fputs("without the book: ./course book builds it\n", stderr);
        return;
    }
    const fs::path site = folder / "book";  // mkdocs does not write it into docs/
    write_site(folder, site, project_from_site);
    fs::rename(site, folder / site_of_handout);
}

/// Returns how many files it consists of.
std::size_t fill(const fs::path& folder) {
    build({"archives"});
    const fs::path archives = build_folder / "archives";
    for (const std::string& path : all_files(archives)) copy_whole(archives / path, folder / path);
    for (const std::string& path : files_for_students())
        copy_whole(project_folder / path, folder / path);
    write_text(folder / "steps/fits.cpp", fits());
    add_book(folder);
    Manifest manifest{.title = "Raysteps, handed out on " + today(), .fingerprints = {}};
    for (const std::string& path : all_files(folder))
        manifest.fingerprints[path] = {fingerprint(folder / path)};
    write_manifest(folder, manifest);
    return manifest.fingerprints.size();
}

/// The folder as an archive that unpacks to its name.
void pack(const fs::path& folder, const fs::path& archive) {
    const ProcessResult ending =
        run_captured({"tar", "-czf", archive.string(), "--owner=0", "--group=0", "-C",
                      folder.parent_path().string(), folder.filename().string()},
                     time_limit);
    if (ending.status != 0) throw ProgramError("error: tar failed\n" + ending.output);
}

void refuse_what_is_there(const fs::path& destination, const fs::path& target) {
    const fs::file_type type = fs::symlink_status(target).type();
    const bool is_free = type == fs::file_type::not_found ||
                         (type == fs::file_type::directory && fs::is_empty(target));
    if (!is_free) throw InputError({destination.string()}, "exists already");
}

}  // namespace

int hand_out(const fs::path& destination) {
    if (std::string(machine).empty())
        throw InputError({}, "hand-outs are made on x86_64 and aarch64");
    if (destination.empty()) throw InputError({}, "handout: expected a name, not \"\"");
    const fs::path target = fs::absolute(destination / "").parent_path();
    refuse_what_is_there(destination, target);
    std::string name = target.filename().string();
    const bool packed = name.size() > std::string(archive_ending).size() &&
                        name.compare(name.size() - 7, 7, archive_ending) == 0;
    if (packed) name.resize(name.size() - 7);

    // Beside it until it is whole.
    fs::create_directories(target.parent_path());
    const TemporaryFolder workshop(target.parent_path());
    const std::size_t files = fill(workshop.path() / name);
    if (packed) pack(workshop.path() / name, workshop.path() / target.filename());
    refuse_what_is_there(destination, target);  // the destination may have been created meanwhile
    fs::rename(workshop.path() / (packed ? target.filename() : fs::path(name)), target);
    std::printf("%s: %zu files, without solutions\nfor %s", destination.c_str(), files,
                fits().substr(3, fits().find('\n') - 2).c_str());
    std::printf("To update an older hand-out: ./course update %s\n", target.filename().c_str());
    return 0;
}

}  // namespace rt
