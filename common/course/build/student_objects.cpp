#include "common/course/build/student_objects.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <set>

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

struct LinkedFile : CompiledFile {
    /// The functions and variables that other objects can see, without those that may be defined in
    /// several objects.
    std::set<std::string> symbols = {};
};

/// Reads the symbols of all files with one nm: to start it takes longer than to read an object.
void read_symbols(std::vector<LinkedFile>& files) {
    constexpr std::size_t most_output = 4'000'000;
    Command command = {"sh", "-c", "nm -gCA \"$@\" | grep ' [TDBR] '", "nm"};
    for (const LinkedFile& each : files) command.push_back(each.object.string());
    const ProcessResult listed = run_captured(command, listing_limit, nullptr, most_output);
    for (const std::string& line : lines_of(listed.output))
        for (LinkedFile& each : files) {
            const std::string object = each.object.string() + ":";
            if (line.rfind(object, 0) != 0) continue;
            const std::size_t type = line.find_first_not_of(" 0123456789abcdef", object.size());
            if (type != std::string::npos && type + 2 < line.size())
                each.symbols.insert(line.substr(type + 2));
        }
}

/// The student's files of all stages that were compiled since they changed.
std::vector<LinkedFile> linked_files() {
    std::vector<LinkedFile> files;
    for (int stage = 1; stage <= int(stage_names.size()); ++stage)
        for (CompiledFile& each : compiled_files(stage)) files.push_back({std::move(each)});
    if (files.size() > 1) read_symbols(files);
    return files;
}

/// True if a program is linked from both: it has one trace, of its last stage.
bool meet(const CompiledFile& earlier, const CompiledFile& later) {
    return earlier.stage < later.stage && earlier.file.filename() != trace_file;
}

}  // namespace

std::vector<CompiledFile> compiled_files(int stage) {
    std::vector<CompiledFile> files;
    for (const fs::path& file : student_files(stage)) {
        const fs::path object = object_of(stage, file, "f64");
        if (is_newer(object, file)) files.push_back({stage, file, object});
    }
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

std::vector<SharedSymbol> shared_symbols(int stage) {
    std::vector<SharedSymbol> shared;
    const std::vector<LinkedFile> files = linked_files();
    for (const LinkedFile& mine : files)
        for (const LinkedFile& other : files)
            if (mine.stage == stage && (meet(mine, other) || meet(other, mine)))
                for (const std::string& name : mine.symbols)
                    if (other.symbols.contains(name))
                        shared.push_back({name, mine.file.lexically_relative(project_folder),
                                          other.file.lexically_relative(project_folder)});
    return shared;
}

}  // namespace rt
