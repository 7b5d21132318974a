#include "common/course/grade/compile.hpp"

#include "common/course/grade/seal.hpp"
#include "common/course/grade/symbols.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <map>
#include <optional>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_source = 256 * 1024;
constexpr std::size_t longest_words = 4000;
constexpr int wall_seconds = 30;

/// How a seat is compiled and linked, as seats/*.txt has it: a name and an option a line.
using Options = std::multimap<std::string, std::string>;

Options read_options(const fs::path& file) {
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

/// The file's text, if it is one: no link, no device, no pipe, of a size that a person writes.
std::optional<std::string> source_text(const fs::path& file) {
    const int source = open(file.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (source == -1) return std::nullopt;
    struct stat about {};
    std::string text(largest_source + 1, '\0');
    const bool is_file = fstat(source, &about) == 0 && S_ISREG(about.st_mode);
    const ssize_t size = is_file ? read(source, text.data(), text.size()) : -1;
    close(source);
    if (size < 0 || std::size_t(size) > largest_source) return std::nullopt;
    text.resize(std::size_t(size));
    return text;
}

/// A folder that is gone with its scope.
class Scratch {
public:
    explicit Scratch(const fs::path& parent) {
        std::string name = parent / "scratch.XXXXXX";
        if (mkdtemp(name.data()) == nullptr) throw ProgramError("no folder in " + parent.string());
        folder_ = name;
    }
    ~Scratch() {
        std::error_code none;
        fs::remove_all(folder_, none);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;

    [[nodiscard]] const fs::path& folder() const { return folder_; }

private:
    fs::path folder_;
};

/// Runs a tool that reads what it is given, and writes into the scratch folder only. Not even all
/// seats: another stage's has the reference of this one in it.
Ending run_sealed(const Workshop& workshop, const Scratch& scratch, const fs::path& readable,
                  const Command& command) {
    Command sealed{workshop.sealed,
                   "work=building",
                   "cpu=15",
                   "wall=" + std::to_string(wall_seconds),
                   "memory=1500",
                   "file=32",
                   "threads=256",
                   "read=" + readable.string(),
                   "write=" + scratch.folder().string(),
                   "--"};
    sealed.insert(sealed.end(), command.begin(), command.end());
    // The launcher watches the clock; we do in case that it cannot.
    Ending ending = listen_to(sealed, std::chrono::seconds(wall_seconds + 10));
    if (ending.status == not_sealed) throw ProgramError(ending.output);
    return ending;
}

/// What is told of a tool that failed: its own words, without our folders' names.
std::string told(const Ending& ending, const Scratch& scratch, const std::string& otherwise) {
    if (ending.out_of_time || ending.status == 128 + SIGXCPU) return otherwise + " took too long.";
    std::string words = ending.output;
    const std::string folder = scratch.folder().string() + "/";
    for (std::size_t at = words.find(folder); at != std::string::npos; at = words.find(folder, at))
        words.erase(at, folder.size());
    if (words.size() > longest_words) words.resize(longest_words);
    return words.empty() ? otherwise + " failed." : words;
}

}  // namespace

Workshop open_workshop(const fs::path& project, const fs::path& build, const fs::path& folder) {
    const fs::path headers = folder / "headers";
    const auto copy_header = [&](const fs::path& header) {
        const fs::path copy = headers / header.lexically_relative(project);
        fs::create_directories(copy.parent_path());
        fs::copy_file(header, copy, fs::copy_options::overwrite_existing);
    };
    for (const auto& each : fs::directory_iterator(project / "common"))
        if (each.path().extension() == ".hpp") copy_header(each.path());
    for (const auto& stage : fs::directory_iterator(project / "steps"))
        if (stage.is_directory())
            for (const auto& each : fs::directory_iterator(stage))
                if (each.path().extension() == ".hpp") copy_header(each.path());
    fs::copy(build / "seats", folder / "seats",
             fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    return {.folder = folder, .sealed = build / "sealed"};
}

Compiled compile_submission(const Workshop& workshop, const std::string& seat, const fs::path& file,
                            const fs::path& worker) {
    const std::optional<std::string> text = source_text(file);
    if (!text) return {.words = "Your file cannot be read, or has more than 256 KiB."};
    const Options options = read_options(workshop.folder / "seats" / (seat + ".txt"));
    const Scratch scratch(workshop.folder);
    const std::string source = scratch.folder() / file.filename();
    const std::string object = scratch.folder() / "submission.o";
    const std::string made = scratch.folder() / "worker";
    std::ofstream(source) << *text;
    fs::permissions(source, fs::perms(0644));

    const fs::path headers = workshop.folder / "headers";
    Command compile;
    append(compile, options, "compiler");
    append(compile, options, "compile");
    compile.insert(compile.end(), {"-I" + headers.string(), "-c", source, "-o", object});
    const Ending compiled = run_sealed(workshop, scratch, headers, compile);
    if (compiled.status != 0) return {.words = told(compiled, scratch, "The compile")};

    const Ending symbols = run_sealed(workshop, scratch, {}, {"/usr/bin/nm", "-g", "-P", object});
    if (symbols.status != 0) return {.words = "Your object cannot be read."};
    if (std::string words = foreign_symbol(symbols.output); !words.empty()) return {.words = words};

    const fs::path others = workshop.folder / "seats" / (seat + ".o");
    Command link;
    append(link, options, "compiler");
    append(link, options, "link");
    link.insert(link.end(), {others, object, "-o", made});
    append(link, options, "library");
    const Ending linked = run_sealed(workshop, scratch, others, link);
    if (linked.status != 0) return {.words = told(linked, scratch, "The link")};
    fs::copy_file(made, worker, fs::copy_options::overwrite_existing);
    fs::permissions(worker, fs::perms(0755));
    const bool is_static = std::find(link.begin(), link.end(), "-static") != link.end();
    return {.made = true, .words = compiled.output, .libraries = !is_static};
}

}  // namespace rt::grade
