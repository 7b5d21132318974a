#include "common/course/build/student_objects.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <string_view>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds listing_limit{5};

std::vector<fs::path> student_files(int stage) {
    return files_in(project_folder / step_path(stage, "student"), ".cpp");
}

/// The object of a student's file, where CMake puts it.
fs::path object_of(int stage, const fs::path& file, const std::string& precision) {
    const std::string part = file.filename() == trace_file ? "_student_main_" : "_student_";
    return build_folder /
           step_path(stage, "CMakeFiles/" + stage_target(stage, part + precision + ".dir")) /
           "student" / (file.filename().string() + ".o");
}

fs::path warnings_of(const fs::path& object) {
    return object.string() + ".warnings";
}

/// True if both exist, and the first was written last.
bool is_newer(const fs::path& made, const fs::path& from) {
    std::error_code none;
    return fs::exists(made, none) && fs::exists(from, none) &&
           fs::last_write_time(made, none) >= fs::last_write_time(from, none);
}

/// Reads the symbols of all files with one nm: to start it takes longer than to read an object.
void read_symbols(std::vector<CompiledFile>& files) {
    constexpr std::size_t most_output = 4'000'000;
    Command command = {"nm", "-AC", "--format=sysv"};
    for (const CompiledFile& each : files) command.push_back(each.object.string());
    const ProcessResult listed = run_captured(command, listing_limit, nullptr, most_output);
    for (const std::string& line : lines_of(listed.output))
        for (CompiledFile& each : files)
            if (const std::string object = each.object.string() + ":"; line.starts_with(object))
                if (const auto symbol = read_symbol(line.substr(object.size())))
                    each.symbols.push_back(*symbol);
}

/// The functions and variables that other objects can see, without those that may be defined in
/// several objects.
std::set<std::string> definitions(const CompiledFile& file) {
    std::set<std::string> names;
    for (const Symbol& each : file.symbols)
        if (std::string_view("TDBR").find(each.kind) != std::string_view::npos)
            names.insert(each.name);
    return names;
}

std::vector<std::string> shared_names(const CompiledFile& file, const CompiledFile& other) {
    std::vector<std::string> names;
    std::ranges::set_intersection(definitions(file), definitions(other), std::back_inserter(names));
    return names;
}

/// True if a program is linked from both: it has one trace, of its last stage.
bool meet(const CompiledFile& earlier, const CompiledFile& later) {
    return earlier.stage < later.stage && earlier.file.filename() != trace_file;
}

}  // namespace

std::optional<Symbol> read_symbol(const std::string& line) {
    std::array<std::size_t, 6> bars{};  // the last ones: a name may have some, too
    std::size_t end = line.size();
    for (auto bar = bars.rbegin(); bar != bars.rend(); end = *bar++) {
        if (end == 0) return std::nullopt;
        *bar = line.rfind('|', end - 1);
        if (*bar == std::string::npos) return std::nullopt;
    }
    const std::size_t start = line.find_first_not_of(' ');
    const std::size_t kind = line.find_first_not_of(' ', bars[1] + 1);
    if (start >= bars[0] || kind >= bars[2]) return std::nullopt;
    const std::size_t last = line.find_last_not_of(' ', bars[0] - 1);
    return Symbol{line.substr(start, last + 1 - start), line[kind], line.substr(bars[5] + 1)};
}

std::vector<CompiledFile> compiled_files() {
    std::vector<CompiledFile> files;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        for (const fs::path& file : student_files(stage)) {
            const fs::path object = object_of(stage, file, "f64");
            if (is_newer(object, file)) files.push_back({stage, file, object});
        }
    if (!files.empty()) read_symbols(files);
    return files;
}

bool is_student_object(const std::string& path) {
    return (path.find("_student_f") != std::string::npos ||
            path.find("_student_main_f") != std::string::npos) &&
           path.find(".dir/student/") != std::string::npos;
}

void outdate_objects(fs::file_time_type build_began) {
    std::error_code none;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        for (const fs::path& file : student_files(stage)) {
            if (fs::last_write_time(file, none) < build_began) continue;
            for (const char* precision : {"f64", "f32"})
                fs::last_write_time(object_of(stage, file, precision), build_began, none);
        }
}

void keep_warnings(const fs::path& object, const std::string& output) {
    write_text(warnings_of(object), output);
}

std::string kept_warnings(int stage) {
    std::string all;
    for (const char* precision : {"f64", "f32"})
        for (const fs::path& file : student_files(stage)) {
            const fs::path object = object_of(stage, file, precision);
            if (is_newer(warnings_of(object), object)) all += read_text(warnings_of(object));
        }
    return all;
}

std::vector<SharedSymbol> shared_symbols(int stage, const std::vector<CompiledFile>& files) {
    std::vector<SharedSymbol> shared;
    for (const CompiledFile& mine : files)
        for (const CompiledFile& other : files)
            if (mine.stage == stage && (meet(mine, other) || meet(other, mine)))
                for (const std::string& name : shared_names(mine, other))
                    shared.push_back({name, mine.file.lexically_relative(project_folder),
                                      other.file.lexically_relative(project_folder)});
    return shared;
}

}  // namespace rt
