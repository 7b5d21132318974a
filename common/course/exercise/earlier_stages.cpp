#include "common/course/exercise/earlier_stages.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/workbook.hpp"

#include <cstdio>

namespace rt {

void show_references_used(int stage) {
    const std::vector<int> others = started_before(stage);
    if (others.empty()) return;
    std::string list;
    for (const int other : others) list += (list.empty() ? "" : ", ") + std::to_string(other);
    std::printf("Judged with the references in place of your %s %s; ./course run %d uses yours.\n",
                others.size() > 1 ? "stages" : "stage", list.c_str(), stage);
}

void warn_of_earlier(int stage, const std::string& references) {
    const std::string without = ";" + references + ";";
    if (without == ";all;") return;
    for (const int other : started_before(stage)) {
        const Workbook workbook(other);
        const std::string number = std::to_string(other);
        const bool is_used = without.find(";" + number + ";") == std::string::npos;
        if (!is_used || workbook.state() == State::done) continue;
        std::fprintf(
            stderr, "your %s is used: %s. See ./course check %d, or leave it out: --reference %d\n",
            stage_name(other).data(), workbook.verdict().c_str(), other, other);
    }
}

}  // namespace rt
