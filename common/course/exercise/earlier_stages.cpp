#include "common/course/exercise/earlier_stages.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/terminal.hpp"
#include "common/system/text.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

namespace rt {

std::string references_used(int stage) {
    const std::vector<int> others = started_before(stage);
    if (others.empty()) return "";
    const auto text = [](int other) { return std::to_string(other); };
    const Values values = {{"others", joined(others, text)}, {"stage", stage}};
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
        print_error(
            tr("your {stage} is used: {verdict}. See ./course check {number}, or leave it "
               "out: --reference {number}",
               {{"stage", name_of(other)}, {"verdict", workbook.verdict()}, {"number", number}}));
    }
}

}  // namespace rt
