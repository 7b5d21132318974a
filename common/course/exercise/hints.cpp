#include "common/course/exercise/hints.hpp"

#include "common/course/build/project.hpp"

#include "common/system/files.hpp"

namespace rt {

std::string hint_text(int stage, int level) {
    std::string text;
    bool inside = false;
    for (const std::string& line :
         lines_of(read_text(project_folder / step_path(stage, "hints.md")))) {
        if (line.rfind("## ", 0) == 0)
            inside = line == "## " + std::to_string(level);
        else if (inside)
            text += line + "\n";
    }
    const std::size_t first = text.find_first_not_of('\n');
    return first == std::string::npos ? "" : text.substr(first);
}

}  // namespace rt
