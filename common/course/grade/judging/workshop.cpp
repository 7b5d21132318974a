#include "common/course/grade/judging/workshop.hpp"

#include "common/course/exercise/may_include.hpp"
#include "common/course/grade/judging/repeatable.hpp"
#include "common/course/grade/judging/symbols.hpp"
#include "common/course/grade/sandbox/seal.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"

#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <sstream>

namespace rt::grade {

namespace {

constexpr std::size_t longest_words = 4000;
// An honest file compiles in less than a second. With the limits of a first compile, a file that
// takes all its time before an error would take it twice.
constexpr ToolLimits of_second_compile{.processor_seconds = 5, .wall_seconds = 8};

/// The compiler and linker options of a link kit, from seats/*.txt: a name and an option per line.
using Options = std::multimap<std::string, std::string>;

fs::path reference_of(const BuildDirectory& workshop, GradedFile graded) {
    return workshop.folder / "seats/references" / (name_of(graded) + ".o");
}

Options read_options(const BuildDirectory& workshop, int stage) {
    const fs::path file = workshop.folder / "seats" / (name_of(stage) + ".txt");
    Options options;
    std::ifstream in(file);
    if (!in) throw ProgramError(file.string() + " does not exist");
    for (std::string line; std::getline(in, line);) {
        const std::size_t space = line.find(' ');
        if (space != std::string::npos && space + 1 < line.size())
            options.emplace(line.substr(0, space), line.substr(space + 1));
    }
    return options;
}

void append(Command& command, const Options& options, const std::string& name) {
    const auto [first, last] = options.equal_range(name);
    for (auto each = first; each != last; ++each) command.push_back(each->second);
}

/// The project's headers that the file may include.
fs::path headers_of(const BuildDirectory& workshop, GradedFile graded) {
    return workshop.folder / "headers" / name_of(graded);
}

/// The header that takes most of a file's compile time.
std::string costliest_header(GradedFile graded) {
    return graded.is_trace ? "common/render/stage.hpp" : stage_header(graded.stage).string();
}

/// The place of a header that the compile begins with, precompiled. All main.cpp share that of
/// stage 1. What functions begin with is less than their stage's header, so it has a name of its
/// own.
fs::path header_of(const BuildDirectory& workshop, GradedFile graded) {
    if (graded.is_trace)
        return headers_of(workshop, GradedFile(1, true)) / costliest_header(graded);
    return headers_of(workshop, graded) / "start.hpp";
}

fs::path precompiled(const fs::path& header) {
    return header.string() + ".gch";
}

StageFunctions functions_of(const BuildDirectory& workshop, GradedFile graded) {
    StageFunctions functions;
    std::ifstream in(workshop.folder / "seats/graded" / (name_of(graded) + ".txt"));
    for (std::string kind, symbol; in >> kind >> symbol;)
        (kind == "own"        ? functions.own
         : kind == "callable" ? functions.callable
                              : functions.others)
            .insert(symbol);
    if (functions.own.empty()) throw ProgramError("seats/graded is incomplete");
    return functions;
}

Command compiler(const BuildDirectory& workshop, GradedFile graded) {
    const Options options = read_options(workshop, graded.stage);
    Command compile;
    append(compile, options, "compiler");
    append(compile, options, "driver");
    append(compile, options, "compile");
    if (!graded.is_trace) append(compile, options, "function");
    compile.push_back("-I" + headers_of(workshop, graded).string());
    return compile;
}

/// True if a line of the output is a tool's own about memory: "cc1plus: out of memory allocating
/// …". Lines on a file start with its name and a colon without a blank, or with blanks.
bool is_short_of_memory(const std::string& output) {
    for (const std::string& line : lines_of(output)) {
        std::string_view words = line;
        const std::size_t end = words.find_first_of(" :");
        if (end != std::string_view::npos && words.substr(end).starts_with(": "))
            words.remove_prefix(end + 2);
        for (const char* each : {"out of memory", "memory exhausted", "virtual memory exhausted",
                                 "LLVM ERROR: out of memory", "cannot allocate memory"})
            if (words.starts_with(each)) return true;
    }
    return false;
}

/// True if a limit, or a signal, ended the tool or the program that it ran. The limit that a bomb
/// reaches first, and its progress until then, depend on the load of the machine.
bool is_bomb(const ProcessResult& ending) {
    return ending.out_of_time || ending.status > 128 || is_short_of_memory(ending.output);
}

/// The message about a failed tool: its own output, identical in every run.
std::string tool_message(const ProcessResult& ending, const BuildDirectory& workshop,
                         GradedFile graded, const TemporaryFolder& scratch,
                         const std::string& otherwise) {
    if (is_bomb(ending)) return otherwise + " took too much time or memory.";
    std::string words =
        repeatable(ending.output, {scratch.path(), headers_of(workshop, graded), workshop.folder});
    if (words.size() > longest_words) words.resize(longest_words);
    return words.empty() ? otherwise + " failed." : words;
}

/// The folders in which a compiler looks for its parts, headers and libraries, as it prints them.
std::vector<fs::path> searched_by(const std::string& compiler) {
    const auto printed = [&compiler](const Command& options) {
        Command command{"env", "-i", "PATH=/usr/local/bin:/usr/bin:/bin", compiler};
        command.insert(command.end(), options.begin(), options.end());
        return lines_of(run_captured(command, std::chrono::seconds(20)).output);
    };
    std::vector<fs::path> folders;
    const auto add = [&folders](const std::string& name) {
        std::error_code none;
        const fs::path folder = fs::canonical(name, none);
        if (fs::is_directory(folder, none) && folder != "/") folders.push_back(folder);
    };
    // "libraries: =/opt/gcc/lib:…", and of the headers' folders each on a line of its own
    for (const std::string& line : printed({"-print-search-dirs"})) {
        std::istringstream names(line.substr(std::min(line.find('/'), line.size())));
        for (std::string name; std::getline(names, name, ':');) add(name);
    }
    for (const std::string& line : printed({"-E", "-v", "-x", "c++", "/dev/null"}))
        if (line.starts_with(" /")) add(line.substr(1));
    return folders;
}

/// A compiler that is not the system's, and its folders: no others that are beside it in ~/.local.
std::vector<fs::path> compiler_files(const std::string& compiler) {
    static std::mutex mutex;
    static std::map<std::string, std::vector<fs::path>> known;
    const std::lock_guard lock(mutex);
    const auto [found, is_new] = known.try_emplace(compiler);
    std::error_code none;
    const fs::path file = fs::canonical(compiler, none);
    if (!is_new || file.empty() || file.parent_path() == "/usr/bin") return found->second;
    found->second = searched_by(compiler);
    found->second.push_back(file);
    return found->second;
}

/// Runs the compiler in the sandbox, which may also read its own files, and the folders of its
/// include options: headers in /home.
ProcessResult run_compiler(const BuildDirectory& workshop, const fs::path& writable,
                           std::vector<fs::path> readable, const Command& command,
                           const ToolLimits& limits = {}) {
    const std::vector<fs::path> own = compiler_files(command.at(0));
    readable.insert(readable.end(), own.begin(), own.end());
    for (const std::string& word : command)
        if (const auto folder = after("-isystem", word)) readable.emplace_back(*folder);
    return run_sealed(workshop, writable, readable, command, limits);
}

/// Makes the contents readable for all users who may enter the folder, with any permissions in the
/// project.
void let_all_read(const fs::path& folder) {
    using fs::perms;
    for (const auto& each : fs::recursive_directory_iterator(folder))
        fs::permissions(each, each.is_directory() ? perms(0755) : perms(0644));
    fs::permissions(folder, perms(0755));
}

/// The header of the project that a compiler did not find, as the file includes it; or nothing.
std::string refused_header(const std::string& words) {
    for (const std::string& line : lines_of(words)) {
        const std::size_t error = line.find("fatal error: ");
        if (error == std::string::npos) continue;
        std::string header = line.substr(error + 13);
        header = header.substr(header.starts_with("'") ? 1 : 0);  // clang++'s
        header = header.substr(0, header.find_first_of("':"));
        for (const char* folder : {"common/", "steps/"})
            if (header.find(folder) != std::string::npos) return header;
    }
    return "";
}

std::string compile_message(const ProcessResult& ending, const BuildDirectory& workshop,
                            GradedFile graded, const TemporaryFolder& scratch) {
    const std::string words = tool_message(ending, workshop, graded, scratch, "The compile");
    const std::string header = refused_header(words);
    if (header.empty()) return words;
    return "Your file includes " + header + ", which this stage must not include: docs/" +
           name_of(graded.stage) + ".md lists the allowed headers.\n" + words;
}

/// "UTF-16" or "UTF-32", by the first bytes or the zeros in every letter; or nothing.
std::string wide_encoding(const std::string& text) {
    const auto starts = [&text](std::string_view bytes) { return text.starts_with(bytes); };
    using namespace std::string_view_literals;
    const auto zeros = std::size_t(std::ranges::count(text, '\0'));
    if (starts("\xff\xfe\0\0"sv) || starts("\0\0\xfe\xff"sv) || zeros > text.size() / 3 * 2)
        return "UTF-32";
    if (starts("\xff\xfe") || starts("\xfe\xff") || zeros > text.size() / 3) return "UTF-16";
    return "";
}

void copy_headers(const fs::path& project, const BuildDirectory& workshop, GradedFile graded) {
    for (const fs::path& header : allowed_headers(project, graded)) {
        const fs::path copy = headers_of(workshop, graded) / header;
        fs::create_directories(copy.parent_path());
        fs::copy_file(project / header, copy, fs::copy_options::skip_existing);
    }
}

/// The precompiled header of a graded file, from the project's build, beside the header: g++ finds
/// it there, and recognizes each header that it contains by the content. With it a file compiles in
/// a third of the time. It is large, so it is a link where it can be one.
void add_precompiled(const BuildDirectory& workshop, GradedFile graded) {
    const Options options = read_options(workshop, graded.stage);
    const auto made = options.find(graded.is_trace ? "main_header" : "header");
    const fs::path place = precompiled(header_of(workshop, graded));
    if (made == options.end() || fs::exists(place)) return;
    fs::create_directories(place.parent_path());
    std::error_code cannot;
    fs::create_hard_link(made->second, place, cannot);
    if (!cannot) fs::permissions(place, fs::perms(0644), cannot);  // not if it is another user's
    if (cannot) fs::copy_file(made->second, place, fs::copy_options::overwrite_existing);
}

/// Moves the result of a sealed tool, which owns it. It is not copied: a process started meanwhile
/// by another thread would keep the copy open, and a program that is open for writing cannot be
/// run.
void take(const fs::path& made, const fs::path& to, fs::perms permissions) {
    fs::rename(made, to);
    if (lchown(to.c_str(), geteuid(), getegid()) != 0) throw ProgramError(to.string() + ": owner");
    fs::permissions(to, permissions);
}

constexpr const char* short_of_memory =
    " was killed, through no limit of the sandbox: this machine has too little memory left. The "
    "same command judges it again\n";

/// A single file is linked to the functions that it may call. Several files were linked this way
/// one by one; together, they are linked to the references of all other files.
std::vector<fs::path> parts_of(const BuildDirectory& workshop, int stage,
                               const std::map<GradedFile, fs::path>& objects) {
    const fs::path seats = workshop.folder / "seats";
    if (objects.empty())
        return {seats / "graded" / (name_of(stage) + ".o"), reference_of(workshop, stage)};
    if (objects.size() == 1 && objects.begin()->first.stage == stage)
        return {seats / "graded" / (name_of(objects.begin()->first) + ".o"),
                objects.begin()->second};
    std::vector<GradedFile> files{GradedFile(stage, true)};
    for (int each = 1; each <= int(stage_names.size()); ++each) files.emplace_back(each);
    std::vector<fs::path> parts{seats / (name_of(stage) + ".o")};
    for (const GradedFile each : files) {
        const auto own = objects.find(each);
        const fs::path part = own == objects.end() ? reference_of(workshop, each) : own->second;
        if (fs::exists(part)) parts.push_back(part);  // stage 13's is not, without OpenMesh
    }
    return parts;
}

}  // namespace

void check_executable(const fs::path& folder) {
    struct statvfs about {};
    if (statvfs(folder.c_str(), &about) == 0 && (about.f_flag & ST_NOEXEC) != 0)
        throw InputError({folder},
                         "no program runs in this folder, which is mounted noexec: "
                         "name another one for temporary files, TMPDIR=/var/tmp");
}

void check_space(const fs::path& folder, std::uintmax_t least) {
    std::error_code unknown;
    const fs::space_info space = fs::space(folder, unknown);
    if (!unknown && space.capacity > 0 && space.available < least)
        throw InputError({folder}, "the disk is full: less than " + std::to_string(least >> 20) +
                                       " MB are left");
}

BuildDirectory open_workshop(const fs::path& project, const fs::path& build,
                             const fs::path& folder) try {
    const BuildDirectory workshop{.folder = folder, .sealed = build / "sealed"};
    fs::copy(build / "seats", folder / "seats",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        for (const GradedFile graded : files_of(stage))
            if (fs::exists(folder / "seats/graded" / (name_of(graded) + ".txt"))) {
                copy_headers(project, workshop, graded);
                add_precompiled(workshop, graded);
            }
    // Copied to a place that the tool's user can read, whoever owns the build folder; and before
    // threads exist, since a program that a process started meanwhile keeps open cannot be run.
    if (fs::exists(build / "unpack")) {
        fs::copy_file(build / "unpack", folder / "unpack", fs::copy_options::overwrite_existing);
        fs::permissions(folder / "unpack", fs::perms(0755));
    }
    for (const char* each : {"headers", "seats"})
        if (fs::exists(folder / each)) let_all_read(folder / each);
    return workshop;
} catch (const fs::filesystem_error&) {
    check_space(folder);
    throw;
}

void go_on(const BuildDirectory& workshop) {
    if (workshop.stop != nullptr && *workshop.stop) throw Interrupted();
}

std::string ended_by_the_clock(const ProcessResult& ending) {
    return " was ended by the clock, after " + formatted("%.1f s", ending.processor_seconds) +
           " of processor time: this machine stood still, or is too busy. The same command judges "
           "it again\n";
}

ProcessResult run_sealed(const BuildDirectory& workshop, const fs::path& writable,
                         const std::vector<fs::path>& readable, const Command& command,
                         const ToolLimits& limits, const fs::path& input) {
    const int wall = int(limits.wall_seconds * busy());
    Command sealed{workshop.sealed,
                   "work=building",
                   "cpu=" + std::to_string(limits.processor_seconds),
                   "wall=" + std::to_string(wall),
                   "memory=1500",
                   "file=" + std::to_string(limits.megabytes),
                   "threads=1000",
                   "write=" + writable.string()};
    for (const fs::path& each : readable) sealed.push_back("read=" + each.string());
    if (!input.empty()) sealed.push_back("input=" + input.string());
    sealed.push_back("--");
    sealed.insert(sealed.end(), command.begin(), command.end());
    // The launcher enforces the time limit; this one is a fallback.
    ProcessResult ending = run_captured(sealed, std::chrono::seconds(wall + 10), workshop.stop);
    go_on(workshop);
    // Slurm signals all processes of a task, possibly the grader last; what it did to the others is
    // no submission's mark.
    if (!ending.out_of_time && is_stopped(ending.status)) throw Interrupted();
    if (ending.status == not_sealed) throw ProgramError(ending.output);
    const bool by_a_limit = ending.out_of_time || ending.status == 128 + SIGXCPU;
    if (ending.processor_seconds < limits.processor_seconds / 2.0) {
        const std::string tool = fs::path(command.at(0)).filename().string();
        if (by_a_limit) throw ProgramError(tool + ended_by_the_clock(ending));
        // The sandbox sends SIGKILL only at the limit of processor time, so here the system sent
        // it, because its memory is full. A submission can choose what a tool prints.
        if (ending.status == 128 + SIGKILL) throw ProgramError(tool + short_of_memory);
    }
    if (ending.status != 0) check_space(writable);
    return ending;
}

Build compile_submission(const BuildDirectory& workshop, GradedFile graded, const std::string& text,
                         const fs::path& object) {
    if (const std::string encoding = wide_encoding(text); !encoding.empty())
        return {.words = "Your file is encoded in " + encoding +
                         ", which a compiler does not read: save it in UTF-8. (In Windows' "
                         "PowerShell, > writes UTF-16.)"};
    const TemporaryFolder scratch(workshop.folder);
    // The file has the student's name for it, relative to the compiler's folder, and an age of its
    // own, so that messages, __FILE__ and __TIMESTAMP__ are the same in every run.
    const std::string source = file_name(graded);
    const fs::path made = scratch.path() / "submission.o";
    write_text(scratch.path() / source, text);
    fs::permissions(scratch.path() / source, fs::perms(0644));
    fs::last_write_time(scratch.path() / source, fs::file_time_type());

    const auto compile = [&](const Command& options, const ToolLimits& limits) {
        Command command = compiler(workshop, graded);
        command.insert(command.end(), options.begin(), options.end());
        command.insert(command.end(), {"-c", source, "-o", made});
        return run_compiler(
            workshop, scratch.path(),
            {headers_of(workshop, graded), precompiled(header_of(workshop, graded))}, command,
            limits);
    };
    // The precompiled header works only as the first include, so it is included first in a file
    // that includes it somewhere. A file that does not compile this way is compiled unchanged.
    const fs::path header = header_of(workshop, graded);
    const std::vector<Include> includes = includes_of(scratch.path() / source);
    const bool starts_from_it = fs::exists(precompiled(header)) &&
                                std::ranges::any_of(includes, [graded](const Include& each) {
                                    return each.header == costliest_header(graded);
                                });
    ProcessResult compiled = compile(starts_from_it ? Command{"-include", header} : Command{}, {});
    if (starts_from_it && compiled.status != 0 && !is_bomb(compiled)) {
        const ProcessResult unchanged = compile({}, of_second_compile);
        if (!is_bomb(unchanged)) compiled = unchanged;
    }
    if (compiled.status != 0)
        return {.words = compile_message(compiled, workshop, graded, scratch)};

    take(made, object, fs::perms(0644));
    const std::optional<ObjectFile> parsed = parse_object(read_text(object));
    std::string words = parsed ? foreign_symbol(*parsed, functions_of(workshop, graded))
                               : "Your object cannot be read.";
    if (!words.empty()) {
        fs::remove(object);
        return {.words = std::move(words)};
    }
    return {.succeeded = true};
}

Build link_worker(const BuildDirectory& workshop, int stage,
                  const std::map<GradedFile, fs::path>& objects, const fs::path& worker) {
    const Options options = read_options(workshop, stage);
    const TemporaryFolder scratch(workshop.folder);
    const std::string made = scratch.path() / "worker";
    const std::vector<fs::path> parts = parts_of(workshop, stage, objects);
    Command link;
    append(link, options, "compiler");
    append(link, options, "driver");
    append(link, options, "link");
    link.insert(link.end(), parts.begin(), parts.end());
    link.insert(link.end(), {"-o", made});
    append(link, options, "library");
    const ProcessResult linked = run_compiler(workshop, scratch.path(), parts, link);
    if (linked.status != 0)
        return {.words = tool_message(linked, workshop, stage, scratch, "The link")};
    take(made, worker, fs::perms(0755));
    return {.succeeded = true};
}

std::string worker_limits(int stage) {
    return stage == mesh_stage ? "cpu=10 memory=1024" : "cpu=10 memory=512";
}

}  // namespace rt::grade
