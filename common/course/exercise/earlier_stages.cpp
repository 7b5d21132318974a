#include "common/course/exercise/earlier_stages.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

#include <cstdio>

namespace rt {

std::string references_used(int stage) {
    const std::vector<int> others = started_before(stage);
    if (others.empty()) return "";
    std::string list;
    for (const int other : others) list += (list.empty() ? "" : ", ") + std::to_string(other);
    const Values values = {{"others", list}, {"stage", std::to_string(stage)}};
    const std::string sentence =
        others.size() > 1 ? tr("Judged with the references in place of your stages {others}; "
                               "./course run {stage} uses yours.",
                               values)
                          : tr("Judged with the references in place of your stage {others}; "
                               "./course run {stage} uses yours.",
                               values);
    return wrapped_prose(sentence) + "\n";
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
            stderr, "%s\n",
            tr("your {stage} is used: {verdict}. See ./course check {number}, or leave it "
               "out: --reference {number}",
               {{"stage", name_of(other)}, {"verdict", workbook.verdict()}, {"number", number}})
                .c_str());
    }
}

}  // namespace rt
