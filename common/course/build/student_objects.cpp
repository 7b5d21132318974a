#include "common/course/build/student_objects.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds time_limit{5};

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

/// The functions and variables that other objects can see, without those that may be defined in
/// several objects, sorted.
std::vector<std::string> symbols(const fs::path& file, const fs::path& object) {
    std::vector<std::string> names;
    if (!is_newer(object, file)) return names;
    const ProcessResult listed = run_captured(
        {"sh", "-c", "nm -gC \"$1\" | sed -n 's/^[0-9a-f]* [TDBR] //p'", "nm", object.string()},
        time_limit);
    names = lines_of(listed.output);
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace

bool is_student_object(const std::string& path) {
    return (path.find("_student_f") != std::string::npos ||
            path.find("_student_main_f") != std::string::npos) &&
           path.find(".dir/student/") != std::string::npos;
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
    for (const fs::path& file : student_files(stage)) {
        const std::vector<std::string> mine = symbols(file, object_of(stage, file, "f64"));
        for (int other = 1; other <= int(stage_names.size()); ++other) {
            if (other == stage) continue;
            for (const fs::path& other_file : student_files(other)) {
                // A program has one trace, of its last stage.
                const bool is_trace = file.filename() == trace_file;
                const bool is_other_trace = other_file.filename() == trace_file;
                if ((is_trace && other > stage) || (is_other_trace && other < stage)) continue;
                for (const std::string& name :
                     symbols(other_file, object_of(other, other_file, "f64")))
                    if (std::binary_search(mine.begin(), mine.end(), name))
                        shared.push_back({name, file.lexically_relative(project_folder),
                                          other_file.lexically_relative(project_folder)});
            }
        }
    }
    return shared;
}

}  // namespace rt
