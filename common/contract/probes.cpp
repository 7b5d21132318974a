#include "common/contract/probes.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace rt::contract {

namespace {

constexpr const char* head =
    "# Calls that distinguish the known mistakes of this stage from the reference and each other,\n"
    "# with the answers, and the cases that each mistake fails. Made by choose_probes from the\n"
    "# suite's own calls, not by hand.\n";

/// "mistake name: sentence" behind its first word.
Mistake read_mistake(const std::string& line) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) throw Malformed("no sentence: " + line);
    return {.name = line.substr(0, colon), .sentence = line.substr(colon + 2)};
}

std::vector<std::string> words_of(const std::string& text) {
    std::istringstream stream(text);
    return {std::istream_iterator<std::string>(stream), {}};
}

std::size_t place_of(const Probes& probes, const std::string& mistake) {
    const auto found = std::ranges::find(probes.mistakes, mistake, &Mistake::name);
    if (found == probes.mistakes.end()) throw Malformed("no mistake " + mistake);
    return std::size_t(found - probes.mistakes.begin());
}

/// "answer | names"
void read_wrong(const Probes& probes, Probe& probe, const std::string& line) {
    const std::size_t bar = line.rfind(" | ");
    if (bar == std::string::npos) throw Malformed("an answer without an owner: " + line);
    const Answer answer = read_answer(*probe.call.callee, std::string_view(line).substr(0, bar));
    for (const std::string& name : words_of(line.substr(bar + 3)))
        probe.mistaken[place_of(probes, name)] = answer;
}

/// "functions: name"
SuiteCase read_case(int stage, const std::string& line) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) throw Malformed("no name of a case: " + line);
    const std::vector<std::string> names = words_of(line.substr(0, colon));
    SuiteCase read{.name = line.substr(colon + 2), .calls = {}};
    for (const Callee& callee : callees())
        if (callee.stage == stage && std::ranges::find(names, callee.name) != names.end())
            read.calls.push_back(&callee);
    return read;
}

/// "..x. name": an x for each case that the mistake fails.
void read_fails(Probes& probes, const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() != 2 || words[0].size() != probes.cases.size())
        throw Malformed("not a mark for each case, and a mistake: " + line);
    std::vector<bool>& fails = probes.mistakes[place_of(probes, words[1])].fails;
    for (const char mark : words[0]) fails.push_back(mark == 'x');
}

/// Within the suites' tolerance; of an open function, exactly: the last digits count there.
double tolerance_of(const Probes& probes, const Call& call) {
    return is_open(probes, *call.callee) ? 0 : right_tolerance;
}

std::string answer_text(const Probes& probes, const Call& call, const Answer& answer) {
    return is_open(probes, *call.callee) && answer.value ? code(*answer.value) : code(answer);
}

std::string cases_text(const Probes& probes) {
    std::string text;
    for (const auto& [name, calls] : probes.cases) {
        std::vector<std::string> names;  // one of overloads
        for (const Callee* const callee : calls)
            if (std::ranges::find(names, callee->name) == names.end())
                names.push_back(callee->name);
        text += "case ";
        for (const std::string& each : names) text += (&each == names.data() ? "" : " ") + each;
        text += ": " + name + "\n";
    }
    for (const Mistake& mistake : probes.mistakes) {
        if (mistake.fails.empty()) continue;
        text += "fails ";
        for (const bool fails : mistake.fails) text += fails ? 'x' : '.';
        text += " " + mistake.name + "\n";
    }
    return text.empty() ? "" : "\n" + text;
}

}  // namespace

CaseResults read_case_results(const std::string& report) {
    CaseResults results;
    std::istringstream lines(report);
    std::string name;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("case ")) {
            name = line.substr(5);
            results[name] = false;
        } else if (line == "passed") {
            results[name] = true;
        }
    }
    return results;
}

Probes read_probes(const std::string& text) {
    Probes probes;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t blank = line.find(' ');
        const std::string word = line.substr(0, blank);
        const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
        if (word == "stage") probes.stage = std::stoi(rest);
        if (word == "mistake") probes.mistakes.push_back(read_mistake(rest));
        if (word == "case") probes.cases.push_back(read_case(probes.stage, rest));
        if (word == "fails") read_fails(probes, rest);
        if (word == "open") probes.open = words_of(rest);
        if (word == "call") probes.probes.push_back({.call = read_call(probes.stage, rest)});
        if (word != "right" && word != "wrong") continue;
        if (probes.probes.empty()) throw Malformed("an answer without a call");
        Probe& probe = probes.probes.back();
        if (word == "right") {
            probe.right = read_answer(*probe.call.callee, rest);
            probe.mistaken.assign(probes.mistakes.size(), probe.right);
        } else {
            read_wrong(probes, probe, rest);
        }
    }
    if (probes.stage == 0) throw Malformed("no stage");
    return probes;
}

std::string text_of(const Probes& probes) {
    std::string text = head + ("stage " + std::to_string(probes.stage)) + "\n";
    for (const Mistake& mistake : probes.mistakes)
        text += "mistake " + mistake.name + ": " + mistake.sentence + "\n";
    if (!probes.open.empty()) {
        text += "open";
        for (const std::string& name : probes.open) text += " " + name;
        text += "\n";
    }
    text += cases_text(probes);
    for (const auto& [call, right, mistaken] : probes.probes) {
        text += "\ncall " + code(call) + "\nright " + answer_text(probes, call, right) + "\n";
        const double within = tolerance_of(probes, call);
        std::vector<bool> counted(mistaken.size());
        for (std::size_t i = 0; i < mistaken.size(); ++i) {
            if (counted[i] || same(mistaken[i], right, within)) continue;
            text += "wrong " + answer_text(probes, call, mistaken[i]) + " |";
            for (std::size_t j = i; j < mistaken.size(); ++j) {
                if (counted[j] || !same(mistaken[j], mistaken[i], within)) continue;
                counted[j] = true;
                text += " " + probes.mistakes[j].name;
            }
            text += "\n";
        }
    }
    return text;
}

bool is_open(const Probes& probes, const Callee& callee) {
    return std::ranges::find(probes.open, callee.name) != probes.open.end();
}

bool is_recognisable(const Probes& probes, const std::string& mistake) {
    const std::size_t place = place_of(probes, mistake);
    return std::ranges::any_of(probes.probes, [&](const Probe& probe) {
        return !same(probe.mistaken[place], probe.right, tolerance_of(probes, probe.call));
    });
}

}  // namespace rt::contract
