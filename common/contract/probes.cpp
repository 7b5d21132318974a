#include "common/contract/probes.hpp"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace rt::contract {

namespace {

constexpr const char* head =
    "# Calls that distinguish the known mistakes of this stage from the reference and each other,\n"
    "# with the answers. Made by choose_probes from the suite's own calls, not by hand.\n";

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

/// The probes of a mistake: those of the functions with wrong answers. Other functions may have
/// other mistakes.
bool errs_in(const Probes& probes, std::size_t mistake, const Callee& callee) {
    return std::ranges::any_of(probes.probes, [&](const Probe& probe) {
        return probe.call.callee == &callee &&
               !same(probe.mistaken[mistake], probe.right, right_tolerance);
    });
}

bool is_recognised(const Probes& probes, std::size_t mistake, const std::vector<Answer>& answers) {
    bool wrong = false;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Probe& probe = probes.probes[i];
        if (!errs_in(probes, mistake, *probe.call.callee)) continue;
        if (!same(answers[i], probe.mistaken[mistake], mistake_tolerance)) return false;
        wrong = wrong || !same(answers[i], probe.right, right_tolerance);
    }
    return wrong;
}

}  // namespace

Probes read_probes(const std::string& text) {
    Probes probes;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const std::size_t blank = line.find(' ');
        const std::string word = line.substr(0, blank);
        const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
        if (word == "stage") probes.stage = std::stoi(rest);
        if (word == "mistake") probes.mistakes.push_back(read_mistake(rest));
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
    for (const auto& [name, sentence] : probes.mistakes)
        text += "mistake " + name + ": " + sentence + "\n";
    if (!probes.open.empty()) {
        text += "open";
        for (const std::string& name : probes.open) text += " " + name;
        text += "\n";
    }
    for (const auto& [call, right, mistaken] : probes.probes) {
        text += "\ncall " + code(call) + "\nright " + code(right) + "\n";
        std::vector<bool> told(mistaken.size());
        for (std::size_t i = 0; i < mistaken.size(); ++i) {
            if (told[i] || same(mistaken[i], right, right_tolerance)) continue;
            text += "wrong " + code(mistaken[i]) + " |";
            for (std::size_t j = i; j < mistaken.size(); ++j) {
                if (told[j] || !same(mistaken[j], mistaken[i], right_tolerance)) continue;
                told[j] = true;
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
        return !same(probe.mistaken[place], probe.right, right_tolerance);
    });
}

std::vector<Mistake> recognised(const Probes& probes, const std::vector<Answer>& answers) {
    std::vector<Mistake> found;
    for (std::size_t i = 0; i < probes.mistakes.size(); ++i)
        if (is_recognised(probes, i, answers)) found.push_back(probes.mistakes[i]);
    return found;
}

}  // namespace rt::contract
