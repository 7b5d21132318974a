#include "common/contract/failing_calls.hpp"

#include <algorithm>
#include <sstream>

namespace rt::contract {

std::optional<Call> call_of_suite(int stage, std::string text) {
    if (text.empty() || text.back() != ')') return std::nullopt;
    try {
        return read_call(stage, text);
    } catch (const Malformed&) {
        text.pop_back();
    }
    try {
        return read_call(stage, text + ", Interval{.min = 0, .max = infinity})");
    } catch (const Malformed&) {
        return std::nullopt;
    }
}

std::vector<Call> failing_calls(int stage, const std::string& report) {
    std::vector<Call> calls;
    std::string question;  // on several lines, before the first entry of a failure: "|   got: …"
    bool is_question = true;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("case ")) {
            question.clear();
            is_question = true;
        }
        if (!line.starts_with("| ") || !is_question) continue;
        const std::string text = line.substr(2);
        const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
        is_question = start != 2;
        if (is_question)
            question += (question.empty() ? "" : " ") + text.substr(start);
        else if (auto call = call_of_suite(stage, question))
            calls.push_back(std::move(*call));
    }
    return calls;
}

}  // namespace rt::contract
