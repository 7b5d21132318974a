#include "common/course/handout/handout.hpp"

#include "common/course/book/site.hpp"
#include "common/course/build/build.hpp"
#include "common/course/build/manifest.hpp"
#include "common/course/build/project.hpp"
#include "common/course/exercise/telling_case.hpp"
#include "common/course/handout/selection.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/version.hpp"

#include <sys/utsname.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <version>

namespace rt {

namespace {

constexpr std::chrono::minutes time_limit{5};
constexpr auto packed_endings = std::to_array<std::string_view>({".tar.gz", ".tgz"});
constexpr auto other_archives =
    std::to_array<std::string_view>({".zip", ".tar", ".tar.xz", ".txz", ".tar.bz2", ".7z", ".rar"});

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
    for (const std::string folder :
         {".devcontainer", ".vscode", "common", "docs", "lang", "scenes", "steps", "tests"})
        for (const std::string& path : all_files(project_folder / folder))
            paths.push_back((folder + "/").append(path));
    std::erase_if(paths, [](const std::string& path) { return !is_for_students(path); });
    return paths;
}

std::vector<std::string> files_for_students() {
    const std::vector<std::string> known = ask_git("");
    if (known.empty()) return look_around();
    for (const std::string& path : ask_git("--others --exclude-standard"))
        print_error(tr("warning: {file} is not in git, and left out", {{"file", path}}));
    return known;
}

/// Debian's name of the compiler for this kind of processor.
std::string cross_compiler(const std::string& processor) {
    return processor + "-linux-gnu-g++";
}

/// A kind of machine for which a hand-out has archives.
struct Machine {
    std::string processor;  ///< the name of their folders: CMake's name of the kind
    int library = 0;        ///< the oldest version of the C++ library with which they can be linked
};

#ifdef _GLIBCXX_RELEASE
constexpr int library_release = _GLIBCXX_RELEASE;
#else
constexpr int library_release = 0;  // of libc++, every version fits
#endif

#ifdef __APPLE__
constexpr const char* system_name = "macOS";
#else
constexpr const char* system_name = "Linux";
#endif

Machine this_machine() {
    utsname system{};
    uname(&system);
    return {.processor = system.machine, .library = library_release};
}

/// The macro that a compiler defines for this kind of processor; empty if it is none for which
/// hand-outs are made.
std::string macro_of(const std::string& processor) {
    if (processor == "x86_64") return "__x86_64__";
    return processor == "aarch64" || processor == "arm64" ? "__aarch64__" : "";
}

/// "x86_64 or aarch64"
std::string processors_of(const std::vector<Machine>& machines) {
    return joined(machines, &Machine::processor, " or ");
}

int newest_library(const std::vector<Machine>& machines) {
    return std::ranges::max(machines, {}, &Machine::library).library;
}

/// The machines for which a hand-out is, in English.
std::string kind_of(const std::vector<Machine>& machines) {
    const int library = newest_library(machines);
    const std::string compiler =
        library == 0 ? "clang++ with libc++"
                     : "g++ " + std::to_string(library) + " or newer, or clang++ with its library";
    return compiler + ", on " + system_name + " with " + processors_of(machines);
}

/// A source that compiles only where the references' objects can be linked. Its first line states
/// this in English.
std::string fits(const std::vector<Machine>& machines) {
    std::string text = "// " + kind_of(machines) + "\n#include <version>\n";
#ifdef __APPLE__
    text += "#ifndef __APPLE__\n#error another system\n#endif\n";
#else
    text += "#ifndef __linux__\n#error another system\n#endif\n";
#endif
    const auto is_for = [](const Machine& of) { return "defined " + macro_of(of.processor); };
    text += "#if !(" + joined(machines, is_for, " || ") + ")\n#error another processor\n#endif\n";
#ifdef _GLIBCXX_USE_CXX11_ABI
    text += "static_assert(_GLIBCXX_RELEASE >= " + std::to_string(newest_library(machines)) +
            " && _GLIBCXX_USE_CXX11_ABI == " + std::to_string(_GLIBCXX_USE_CXX11_ABI) + ");\n";
#else
    text += "static_assert(_LIBCPP_VERSION > 0);\n";
#endif
    return text + "static_assert(sizeof(void*) == " + std::to_string(sizeof(void*)) +
           ");\nint main() {}\n";
}

/// The machine of this kind of processor whose archives Debian's cross compiler can build. Throws
/// InputError if there is no such kind, or no compiler.
Machine other_machine(const std::string& processor) {
    if (processor != "x86_64" && processor != "aarch64")
        throw InputError({},
                         "handout: --also: expected x86_64 or aarch64, not \"" + processor + "\"");
    if (library_release == 0 || this_machine().processor == processor)
        throw InputError({}, "handout: --also " + processor +
                                 ": expected another processor than this machine's, on Linux");
    const std::string compiler = cross_compiler(processor);
    const std::string package =
        processor == "x86_64" ? "g++-x86-64-linux-gnu" : "g++-" + processor + "-linux-gnu";
    try {
        const ProcessResult version = run_captured({compiler, "-dumpversion"}, time_limit);
        if (version.status == 0)
            return {.processor = processor, .library = std::stoi(version.output)};
    } catch (const std::exception&) {
        // it is not there, or is none
    }
    throw InputError(
        {}, "handout: --also " + processor + " needs " + compiler + ": apt-get install " + package);
}

/// The pages of the hand-out as a site, if that of the clone was built once.
void add_book(const fs::path& folder) {
    if (!fs::exists(project_folder / site_of_clone)) {
        print_error(tr("without the book: ./course book builds it"));
        return;
    }
    const fs::path site = folder / "book";  // mkdocs does not write it into docs/
    write_site(folder, site, project_from_site);
    fs::rename(site, folder / site_of_handout);
}

/// Builds the archives for another kind of processor, in a build folder of their own.
fs::path build_archives(const std::string& processor) {
    const fs::path folder = build_folder / ("handout_" + processor);
    StatusLine status("building for " + processor + " …");
    const Command configure{"cmake", "-S", project_folder.string(), "-B", folder.string(), "-G",
                            "Ninja", "-DCMAKE_SYSTEM_NAME=Linux",
                            "-DCMAKE_SYSTEM_PROCESSOR=" + processor,
                            "-DCMAKE_CXX_COMPILER=" + cross_compiler(processor),
                            "-DRAYSTEPS_TESTS=OFF", "-DRAYSTEPS_ANY_PROCESSOR=ON",
                            // What an archive is not linked with need not be for its processor.
                            "-DPNG_LIBRARY=/dev/null", "-DPNG_PNG_INCLUDE_DIR=/usr/include",
                            "-DZLIB_LIBRARY=/dev/null", "-DZLIB_INCLUDE_DIR=/usr/include"};
    for (const Command& command :
         {configure, Command{"ninja", "-C", folder.string(), "archives"}}) {
        std::string output;
        const auto hear = [&](std::string_view piece) {
            output += piece;
            status.show_again();
        };
        if (run_heard(command, Streams::both, hear) != 0)
            throw ProgramError("error: " + command[0] + " failed\n" + output);
    }
    return folder / "archives";
}

/// The catalogues of known mistakes without their changes: which case catches each
/// (telling_case.hpp).
void add_authors_cases(const fs::path& folder) {
    const fs::path target = folder / in_handout(mistakes_folder);
    fs::create_directories(target);
    for (const fs::path& catalogue : files_in(project_folder / mistakes_folder, ".txt"))
        write_text(target / catalogue.filename(), authors_cases(read_text(catalogue)));
}

/// Leaves out of the translations what the pages of the hand-out do not contain.
void select_translations(const fs::path& folder) {
    for (const std::string& path : all_files(folder / "lang")) {
        const fs::path page = fs::path(path.substr(path.find('/') + 1)).replace_extension(".md");
        if (!path.ends_with(".po") || !fs::exists(project_folder / page)) continue;
        const fs::path catalogue = folder / "lang" / path;
        std::string pages;
        for (const fs::path& each : {page, "steps" / page.stem() / "hints.md"})
            if (fs::exists(folder / each)) pages += read_text(folder / each);
        const std::string text = pages.empty() ? "" : selected_entries(read_text(catalogue), pages);
        if (text.empty())
            fs::remove(catalogue);
        else
            write_text(catalogue, text);
    }
}

/// Replaces the English pages.
void translate_pages(const fs::path& folder, const std::string& language) {
    const ProcessResult ending = run_captured(
        {"python3", (folder / "lang/pages.py").string(), "--in-place", language}, time_limit);
    if (ending.status != 0) throw ProgramError(ending.output);
}

/// Returns how many files it consists of.
std::size_t fill(const fs::path& folder, const std::vector<Machine>& machines,
                 const Selection& selection) {
    build({"archives"});
    for (const Machine& machine : machines) {
        const bool is_this = &machine == machines.data();
        const fs::path archives =
            is_this ? build_folder / "archives" : build_archives(machine.processor);
        for (const std::string& path : all_files(archives))
            if (fs::path(path).parent_path().filename() == machine.processor)
                copy_whole(archives / path, folder / path);
    }
    for (const std::string& path : files_for_students())
        if (is_selected(selection, path)) copy_whole(project_folder / path, folder / path);
    for (const std::string& path : all_files(folder))
        if (path.ends_with(".md"))
            write_text(folder / path, selected_text(selection, path, read_text(folder / path)));
    select_translations(folder);
    add_authors_cases(folder);
    write_text(folder / "steps/fits.cpp", fits(machines));
    add_book(folder);  // of whole pages, which their translations are of
    if (!selection.language.empty()) translate_pages(folder, selection.language);
    for (const std::string& path : all_files(folder))
        if (path.ends_with(".md"))
            write_text(folder / path,
                       with_live_links(read_text(folder / path), (folder / path).parent_path()));
    Manifest manifest{.title = "Raysteps, version " + version(project_folder) + ", handed out on " +
                               today() + " for " + kind_of(machines),
                      .fingerprints = {}};
    for (const std::string& path : all_files(folder))
        manifest.fingerprints[path] = {fingerprint(folder / path)};
    write_manifest(folder, manifest);
    return manifest.fingerprints.size();
}

/// The folder as an archive that unpacks to its name.
void pack(const fs::path& folder, const fs::path& archive) {
    ProcessResult ending;
    for (const auto& [owner, group] : {std::pair("--owner=0", "--group=0"),  // GNU's
                                       std::pair("--uid=0", "--gid=0")}) {   // macOS's
        ending = run_captured({"tar", "-czf", archive.string(), owner, group, "-C",
                               folder.parent_path().string(), folder.filename().string()},
                              time_limit);
        if (ending.status == 0) return;
    }
    throw ProgramError("error: tar failed\n" + ending.output);
}

}  // namespace

int hand_out(const fs::path& destination, const std::vector<std::string>& also,
             const Selection& selection) {
    std::vector<Machine> machines{this_machine()};
    if (macro_of(machines[0].processor).empty())
        throw InputError({}, "hand-outs are made on x86_64 and aarch64");
    if (destination.empty()) throw InputError({}, "handout: expected a name, not \"\"");
    const fs::path target = fs::absolute(destination / "").parent_path();
    refuse_what_is_there(destination, target);
    for (const std::string& processor : also) {
        const auto is_same = [&](const Machine& known) { return known.processor == processor; };
        if (std::none_of(machines.begin() + 1, machines.end(), is_same))
            machines.push_back(other_machine(processor));
    }
    std::string name = target.filename().string();
    if (!ending_of(name, other_archives).empty())
        throw InputError({destination.string()}, "hand-outs are packed as .tar.gz or .tgz");
    const std::string_view packed_ending = ending_of(name, packed_endings);
    const bool packed = !packed_ending.empty();
    name.resize(name.size() - packed_ending.size());

    // Beside it until it is whole.
    fs::create_directories(target.parent_path());
    const TemporaryFolder workshop(target.parent_path());
    const std::size_t files = fill(workshop.path() / name, machines, selection);
    if (packed) pack(workshop.path() / name, workshop.path() / target.filename());
    refuse_what_is_there(destination, target);  // the destination may have been created meanwhile
    fs::rename(workshop.path() / (packed ? target.filename() : fs::path(name)), target);
    print_line(tr("{folder}: {number} files, without solutions\nfor {machines}",
                  {{"folder", destination.string()},
                   {"number", files},
                   {"machines", tr_text(kind_of(machines))}}));
    print_line(tr("To update an older hand-out: ./course update {name}",
                  {{"name", shell_word(target.filename().string())}}));
    return 0;
}

}  // namespace rt
