#include "common/course/own/own.hpp"

#include "common/course/exercise/may_include.hpp"
#include "common/stages/stages.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>
#include <vector>

namespace rt {

namespace {

constexpr const char* main_cpp =
    R"(// A ray tracer of your own. docs/your_own.md of Raysteps leads from here to a picture:
//
//   1. a picture file
//   2. a loop over its pixels, with camera_ray and camera_basis
//   3. the nearest of a list of shapes
//   4. a scene from a file
//   5. light and shadow
//   6. a comparison with the pictures of Raysteps: ./course own --check and this folder

int main() {}
)";

constexpr const char* cmake_lists = R"(cmake_minimum_required(VERSION 3.22)
project(tracer CXX)
set(CMAKE_CXX_STANDARD 20)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)  # optimized: ten times as fast
endif()
find_package(glm REQUIRED)
file(GLOB stages CONFIGURE_DEPENDS steps/*/student/*.cpp common/*/*.cpp)
add_executable(tracer main.cpp ${stages})
target_include_directories(tracer PRIVATE ${PROJECT_SOURCE_DIR})
target_compile_definitions(tracer PRIVATE GLM_FORCE_CTOR_INIT)  # GLM's vectors start as zeros
target_link_libraries(tracer PRIVATE glm::glm)
)";

constexpr const char* readme = R"(# A ray tracer of my own

    cmake -G Ninja -S . -B build
    cmake --build build
    build/tracer scene.rt picture.ppm

The guide is )";

/// The student's files of a stage, as paths in the project, except `trace`, which needs the
/// renderer; none if the stage is not started.
std::vector<fs::path> files_of(const fs::path& project, int stage) {
    const fs::path folder = fs::path("steps") / stage_name(stage) / "student";
    std::vector<fs::path> files;
    for (const fs::path& file : files_in(project / folder, ".cpp"))
        if (file.filename() != "main.cpp") files.push_back(folder / file.filename());
    return files;
}

/// The file of the project that an #include in the given file names, as a path in the project;
/// nothing for a header of a library.
std::optional<fs::path> included_file(const fs::path& project, const fs::path& file,
                                      const Include& include) {
    for (const fs::path& candidate :
         {file.parent_path() / include.header, fs::path(include.header)}) {
        const fs::path path = candidate.lexically_normal();
        const bool is_outside = path.is_absolute() || *path.begin() == "..";
        if (!is_outside && fs::is_regular_file(project / path)) return path;
    }
    return std::nullopt;
}

void warn(const std::string& place, const std::string& what) {
    print_error(place + tr("warning: {what}", {{"what", what}}));
}

/// The contents of the new folder, without those that are the same for everybody.
class Layout {
public:
    explicit Layout(fs::path project) : project_(std::move(project)) {
        for (int stage = 1; stage <= int(stage_names.size()); ++stage)
            (files_of(project_, stage).empty() ? left_out_ : stages_).push_back(stage);
        for (const int stage : stages_)
            for (const fs::path& file : files_of(project_, stage)) {
                add(file);
                warn_of_includes(stage, file);
            }
        add("common/math/vector.hpp");
        // An unfinished function calls it, to report that it is not written yet.
        if (files_.count("common/stages/todo.hpp") > 0) add("common/stages/todo.cpp");
    }

    [[nodiscard]] const std::set<fs::path>& files() const { return files_; }
    [[nodiscard]] const std::vector<int>& stages() const { return stages_; }
    [[nodiscard]] const std::vector<int>& left_out() const { return left_out_; }

private:
    /// Adds the file and everything of the project that it includes.
    void add(const fs::path& first) {
        std::vector<fs::path> wanted = {first};
        while (!wanted.empty()) {
            const fs::path file = wanted.back();
            wanted.pop_back();
            if (!files_.insert(file).second) continue;
            for (const Include& include : includes_of(project_ / file))
                if (const auto path = included_file(project_, file, include))
                    wanted.push_back(*path);
        }
    }

    void warn_of_includes(int stage, const fs::path& file) const {
        const std::set<fs::path> allowed = allowed_headers(project_, stage);
        for (const Include& include : includes_of(project_ / file)) {
            const auto path = included_file(project_, file, include);
            if (!path || path->parent_path() == file.parent_path()) continue;
            const std::string place = to_string({.file = file.string(), .line = include.line});
            if (allowed.count(*path) == 0)
                warn(place, tr("{file} is not a header of this stage: it is copied, with all that "
                               "it includes, but without the code behind it",
                               {{"file", path->string()}}));
            for (const int other : left_out_)
                if (*path == stage_header(other))
                    warn(place, tr("{stage} is not started: if its functions are called here, the "
                                   "linker will not find them",
                                   {{"stage", name_of(other)}}));
        }
    }

    fs::path project_;
    std::set<fs::path> files_;
    std::vector<int> stages_;
    std::vector<int> left_out_;
};

void write(const Layout& layout, const fs::path& project, const fs::path& folder) {
    for (const fs::path& file : layout.files()) copy_whole(project / file, folder / file);
    write_text(folder / "main.cpp", main_cpp);
    write_text(folder / "CMakeLists.txt", cmake_lists);
    write_text(folder / "README.md", readme + (project / "docs/your_own.md").string() + "\n");
}

}  // namespace

int lay_out_own(const fs::path& project, const fs::path& destination) {
    if (destination.empty()) throw InputError({}, tr("own: expected a name, not \"\""));
    const fs::path target = fs::absolute(destination / "").lexically_normal().parent_path();
    refuse_what_is_there(destination, target);
    const Layout layout(project);
    if (layout.stages().empty())
        throw InputError({}, tr("no stage is started, so there is nothing to build on: ./course "
                                "start 1"));

    // Beside it until it is whole.
    fs::create_directories(target.parent_path());
    const TemporaryFolder workshop(target.parent_path());
    const fs::path folder = workshop.path() / "own";
    write(layout, project, folder);
    refuse_what_is_there(destination, target);  // the destination may have been created meanwhile
    fs::rename(folder, target);

    const Values values = {{"folder", destination.string()}, {"number", layout.stages().size()}};
    print_line(
        layout.stages().size() == 1
            ? tr("{folder}: your files of one stage, and the headers that they include", values)
            : tr("{folder}: your files of {number} stages, and the headers that they include",
                 values));
    const auto name = [](int stage) { return name_of(stage); };
    if (const std::string left_out = joined(layout.left_out(), name); !left_out.empty())
        print_line(tr("left out, as not started: {stages}", {{"stages", left_out}}));
    print_line(tr("build: {command}", {{"command", own_build_command(destination)}}));
    print_line(tr("read:  docs/your_own.md"));
    return 0;
}

std::string own_build_command(const fs::path& folder) {
    const std::string build = shell_word((folder / "build").string());
    return "cmake -G Ninja -S " + shell_word(folder.string()) + " -B " + build +
           " && cmake --build " + build;
}

}  // namespace rt
