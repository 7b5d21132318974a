#include "common/course/grade/results/classes.hpp"

#include "common/course/grade/results/sha256.hpp"

#include "common/system/files.hpp"
#include "common/system/input_error.hpp"

#include <algorithm>
#include <fstream>

namespace rt::grade {

namespace {

namespace fs = std::filesystem;

constexpr const char* classes_file = ".classes";

std::vector<std::string> graded_classes(const fs::path& results) {
    const fs::path file = results / classes_file;
    return fs::exists(file) ? lines_of(read_text(file)) : std::vector<std::string>{};
}

std::string line_of(const fs::path& place, const std::string& student) {
    return sha256(fs::canonical(place).string()) + " " + student;
}

bool contains(const std::vector<std::string>& classes, const std::string& line) {
    return std::find(classes.begin(), classes.end(), line) != classes.end();
}

}  // namespace

bool is_graded_at(const fs::path& results, const fs::path& place, const std::string& student) {
    const std::vector<std::string> classes = graded_classes(results);
    return classes.empty() || contains(classes, line_of(place, student));
}

void add_graded_class(const fs::path& results, const fs::path& place,
                      const std::vector<std::string>& students) {
    const std::vector<std::string> classes = graded_classes(results);
    std::string added;
    for (const std::string& each : students)
        if (const std::string line = line_of(place, each); !contains(classes, line))
            added += line + "\n";
    const fs::path file = results / classes_file;
    std::ofstream out(file, std::ios::app);
    out << added << std::flush;
    if (!out) throw InputError({file.string()}, "cannot be written");
}

}  // namespace rt::grade
