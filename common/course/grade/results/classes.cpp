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

bool contains(const std::vector<std::string>& classes, const fs::path& place) {
    return std::find(classes.begin(), classes.end(), sha256(fs::canonical(place).string())) !=
           classes.end();
}

}  // namespace

bool is_graded_class(const fs::path& results, const fs::path& place) {
    const std::vector<std::string> classes = graded_classes(results);
    return classes.empty() || contains(classes, place);
}

void add_graded_class(const fs::path& results, const fs::path& place) {
    if (contains(graded_classes(results), place)) return;
    const fs::path file = results / classes_file;
    std::ofstream out(file, std::ios::app);
    out << sha256(fs::canonical(place).string()) + "\n" << std::flush;
    if (!out) throw InputError({file.string()}, "cannot be written");
}

}  // namespace rt::grade
