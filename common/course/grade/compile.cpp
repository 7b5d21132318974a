#include "common/course/grade/compile.hpp"

#include "common/course/files.hpp"
#include "common/course/grade/seal.hpp"
#include "common/course/grade/symbols.hpp"

#include "common/stages.hpp"

#include <unistd.h>

#include <csignal>
#include <fstream>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t longest_words = 4000;
constexpr int wall_seconds = 30;

/// How a seat is compiled and linked, as seats/*.txt has it: a name and an option a line.
using Options = std::multimap<std::string, std::string>;

std::string name_of(int stage) {
    return std::string(stage_name(stage));
}

fs::path reference_of(const Workshop& workshop, int stage) {
    return workshop.folder / "seats/references" / (name_of(stage) + ".o");
}

Options read_options(const Workshop& workshop, int stage) {
    const fs::path file = workshop.folder / "seats" / (name_of(stage) + ".txt");
    Options options;
    std::ifstream in(file);
    if (!in) throw ProgramError(file.string() + " is not there");
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

std::string header_of(const Workshop& workshop, int stage) {
    const std::string name = name_of(stage);
    return workshop.folder / "headers/steps" / name / (name.substr(7) + ".hpp");
}

Command compiler(const Workshop& workshop, int stage) {
    const Options options = read_options(workshop, stage);
    Command compile;
    append(compile, options, "compiler");
    append(compile, options, "compile");
    compile.push_back("-I" + (workshop.folder / "headers").string());
    return compile;
}

/// Ended by a limit. Which one ends a bomb, and how far it came, depends on what else the machine
/// does.
bool is_bomb(const Ending& ending) {
    const auto says = [&ending](const char* words) {
        return ending.output.find(words) != std::string::npos;
    };
    return ending.out_of_time || ending.status == 128 + SIGXCPU ||
           says("signal terminated program") || says("out of memory") || says("memory exhausted") ||
           says("cannot allocate memory");
}

/// What is told of a tool that failed: its own words, without our folders' names.
std::string told(const Ending& ending, const Workshop& workshop, const TemporaryFolder& scratch,
                 const std::string& otherwise) {
    if (is_bomb(ending)) return otherwise + " took too much time or memory.";
    std::string words = ending.output;
    for (const fs::path& folder : {scratch.path(), workshop.folder / "headers", workshop.folder}) {
        const std::string name = folder.string() + "/";
        for (std::size_t at = words.find(name); at != std::string::npos; at = words.find(name, at))
            words.erase(at, name.size());
    }
    if (words.size() > longest_words) words.resize(longest_words);
    return words.empty() ? otherwise + " failed." : words;
}

void copy_headers(const fs::path& project, const fs::path& folder, const fs::path& headers) {
    for (const auto& each : fs::directory_iterator(folder)) {
        if (each.path().extension() != ".hpp") continue;
        const fs::path copy = headers / each.path().lexically_relative(project);
        fs::create_directories(copy.parent_path());
        fs::copy_file(each.path(), copy, fs::copy_options::overwrite_existing);
    }
}

/// Moves what a sealed tool has made, and owns. Not a copy of ours: a process that another thread
/// starts meanwhile would hold it open, and a program that is written to cannot be run.
void take(const fs::path& made, const fs::path& to, fs::perms permissions) {
    fs::rename(made, to);
    if (lchown(to.c_str(), geteuid(), getegid()) != 0) throw ProgramError(to.string() + ": owner");
    fs::permissions(to, permissions);
}

}  // namespace

Workshop open_workshop(const fs::path& project, const fs::path& build, const fs::path& folder) {
    copy_headers(project, project / "common", folder / "headers");
    for (const auto& stage : fs::directory_iterator(project / "steps"))
        if (stage.is_directory()) copy_headers(project, stage, folder / "headers");
    fs::copy(build / "seats", folder / "seats",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    return {.folder = folder, .sealed = build / "sealed"};
}

void precompile_header(const Workshop& workshop, int stage) {
    const std::string header = header_of(workshop, stage);
    Command compile = compiler(workshop, stage);
    compile.insert(compile.end(), {"-x", "c++-header", header, "-o", header + ".gch"});
    const Ending ending = listen_to(compile, std::chrono::seconds(4 * wall_seconds));
    if (ending.status != 0) throw ProgramError(ending.output);
}

Ending run_sealed(const Workshop& workshop, const fs::path& writable,
                  const std::vector<fs::path>& readable, const Command& command) {
    Command sealed{
        workshop.sealed, "work=building", "cpu=15",      "wall=" + std::to_string(wall_seconds),
        "memory=1500",   "file=32",       "threads=256", "write=" + writable.string()};
    for (const fs::path& each : readable) sealed.push_back("read=" + each.string());
    sealed.push_back("--");
    sealed.insert(sealed.end(), command.begin(), command.end());
    // The launcher watches the clock; we do in case that it cannot.
    Ending ending = listen_to(sealed, std::chrono::seconds(wall_seconds + 10));
    if (ending.status == not_sealed) throw ProgramError(ending.output);
    return ending;
}

Made compile_submission(const Workshop& workshop, int stage, const std::string& text,
                        const fs::path& object) {
    const TemporaryFolder scratch(workshop.folder);
    // Named as the student knows it: the compiler's words say so.
    const std::string source = scratch.path() / (name_of(stage).substr(7) + ".cpp");
    const std::string made = scratch.path() / "submission.o";
    std::ofstream(source) << text;
    fs::permissions(source, fs::perms(0644));

    const auto compile = [&](const Command& options) {
        Command command = compiler(workshop, stage);
        command.insert(command.end(), options.begin(), options.end());
        command.insert(command.end(), {"-c", source, "-o", made});
        return run_sealed(workshop, scratch.path(), {workshop.folder / "headers"}, command);
    };
    // The stage's header is compiled ahead, which helps those only who include nothing before it:
    // so it goes first. Whoever minds is compiled as he is.
    Ending compiled = compile({"-include", header_of(workshop, stage)});
    if (compiled.status != 0 && !is_bomb(compiled)) compiled = compile({});
    if (compiled.status != 0) return {.words = told(compiled, workshop, scratch, "The compile")};

    const Ending symbols =
        run_sealed(workshop, scratch.path(), {}, {"/usr/bin/nm", "-g", "-P", made});
    if (symbols.status != 0) return {.words = "Your object cannot be read."};
    if (std::string words = foreign_symbol(symbols.output); !words.empty()) return {.words = words};
    take(made, object, fs::perms(0644));
    return {.succeeded = true};
}

Made link_worker(const Workshop& workshop, int stage, const std::map<int, fs::path>& objects,
                 const fs::path& worker) {
    const Options options = read_options(workshop, stage);
    const TemporaryFolder scratch(workshop.folder);
    const std::string made = scratch.path() / "worker";
    // Of the references those that are needed: not even the linker sees the graded stage's.
    std::vector<fs::path> parts{workshop.folder / "seats" / (name_of(stage) + ".o")};
    for (int each = 1; each <= int(stage_names.size()); ++each) {
        const auto own = objects.find(each);
        const fs::path part = own == objects.end() ? reference_of(workshop, each) : own->second;
        if (fs::exists(part)) parts.push_back(part);  // stage 13's is not, without OpenMesh
    }
    Command link;
    append(link, options, "compiler");
    append(link, options, "link");
    link.insert(link.end(), parts.begin(), parts.end());
    link.insert(link.end(), {"-o", made});
    append(link, options, "library");
    const Ending linked = run_sealed(workshop, scratch.path(), parts, link);
    if (linked.status != 0) return {.words = told(linked, workshop, scratch, "The link")};
    take(made, worker, fs::perms(0755));
    return {.succeeded = true};
}

std::string worker_limits(int stage) {
    return stage == mesh_stage ? "cpu=10 memory=1024 libraries=1" : "cpu=10 memory=512";
}

}  // namespace rt::grade
