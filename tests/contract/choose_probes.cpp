// choose_probes REPORTS PROJECT STAGE REFERENCE ANSWERS SUITE
//
// Writes a stage's probes.txt to the standard output: a few of the calls that its suite made
// (REPORTS/record, with REPORTS/reference.report), which separate every known mistake from the
// reference and from the others, and the cases that fail. REFERENCE and ANSWERS are workers; SUITE
// is the suite, linked to the known mistakes.
#include "common/contract/contracts.hpp"
#include "common/contract/probes.hpp"
#include "common/stages/stages.hpp"

#include "tests/contract/answers.hpp"

#include <algorithm>
#include <iostream>
#include <map>
#include <set>
#include <sstream>

namespace rt::contract {

namespace {

constexpr std::size_t most_probes = 96;
constexpr int times_separated = 5;        ///< each mistake from the reference
constexpr int calls_of_each = 16;         ///< per function, at least
constexpr int calls_of_open = 16;         ///< per open function: not all have to match
constexpr int most_of_case = 2000;        ///< of one test case, per function
constexpr int most_plain = 300;           ///< of these, the plainest
constexpr int most_calls_of_each = 1500;  ///< of these, from plain to complex
/// A function is open if another right one answers that share of its calls otherwise.
constexpr double open_share = 0.05;
constexpr std::size_t longest_call = 1200;  // characters: meshes are long

/// True for many points of a light, or a picture.
bool is_batch(const std::string& question) {
    return question.front() == '\0';
}

/// The functions of the stage that each case has called: a picture calls them all.
std::vector<SuiteCase> cases_of(const std::string& record, const std::string& report, int stage) {
    std::vector<SuiteCase> cases;
    std::istringstream lines(report);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("case ")) cases.push_back({.name = line.substr(5), .calls = {}});
    Reader reader(record);
    std::size_t next = 0;
    const auto calls = [&](const Callee& callee) {
        auto& all = cases.at(next - 1).calls;
        if (std::ranges::find(all, &callee) == all.end()) all.push_back(&callee);
    };
    while (reader.left() > 0) {
        std::string question(get<std::uint32_t>(reader), '\0');
        reader.raw(question.data(), question.size());
        if (question.empty()) {
            ++next;
        } else if (is_batch(question)) {
            const bool is_picture = std::uint8_t(question[1]) == picture_place;
            for (const Callee& callee : callees())
                if (callee.stage == stage && (is_picture || callee.name == "sample_light"))
                    calls(callee);
        } else if (const Call call = call_of(question); call.callee->stage == stage) {
            calls(*call.callee);
        }
    }
    for (SuiteCase& each : cases) std::ranges::sort(each.calls, {}, &Callee::place);
    return cases;
}

/// The recorded calls of the stage, each once, the plainest first.
std::vector<Call> recorded(const std::string& record, int stage) {
    Reader reader(record);
    std::set<std::string> seen;
    std::map<const Callee*, int> count;
    std::map<const Callee*, int> in_case;
    std::vector<std::pair<std::string, Call>> calls;
    while (reader.left() > 0) {
        std::string question(get<std::uint32_t>(reader), '\0');
        reader.raw(question.data(), question.size());
        if (question.empty()) in_case.clear();
        if (question.empty() || is_batch(question) || !seen.insert(question).second) continue;
        const Call call = call_of(question);
        if (in_case[call.callee]++ >= most_of_case) continue;
        ++count[call.callee];
        std::string text = code(call);
        if (call.callee->stage == stage && text.size() <= longest_call)
            calls.emplace_back(std::move(text), call);
    }
    std::map<const Callee*, int> every_of;
    for (const auto& [callee, read] : count) every_of[callee] = 1 + read / most_calls_of_each;
    std::ranges::stable_sort(calls, {}, [](const auto& call) { return call.first.size(); });
    count.clear();
    std::vector<Call> plainest;
    for (const auto& [text, call] : calls)
        if (count[call.callee]++ % every_of[call.callee] == 0 || count[call.callee] <= most_plain)
            plainest.push_back(call);
    return plainest;
}

struct Table {
    std::vector<Call> calls;
    std::vector<Answer> right;
    std::vector<std::vector<Answer>> mistaken;  ///< one list of answers a mistake
};

bool differ(const Call& call, bool is_open, const Answer& a, const Answer& b) {
    return is_open ? !same_kind(call, a, b) : !same(a, b, mistake_tolerance);
}

/// Removes calls with several right answers, and names the functions with most of them.
std::vector<std::string> take_out_open(Table& table, const Answers& known) {
    std::set<std::size_t> out;
    std::set<const Callee*> open;
    for (const std::string& alternative : known.alternatives()) {
        const std::vector<Answer> answers = known.as(alternative)(table.calls);
        for (const Callee& callee : callees()) {
            std::vector<std::size_t> otherwise;
            double count = 0;
            for (std::size_t i = 0; i < answers.size(); ++i) {
                if (table.calls[i].callee != &callee) continue;
                ++count;
                if (!same(answers[i], table.right[i], right_tolerance)) otherwise.push_back(i);
            }
            if (is_compared_by_kind(callee) || double(otherwise.size()) > open_share * count)
                open.insert(&callee);
            else
                out.insert(otherwise.begin(), otherwise.end());
        }
    }
    std::erase_if(out, [&](std::size_t i) { return open.contains(table.calls[i].callee); });
    for (auto i = out.rbegin(); i != out.rend(); ++i) {
        table.calls.erase(table.calls.begin() + std::ptrdiff_t(*i));
        table.right.erase(table.right.begin() + std::ptrdiff_t(*i));
    }
    std::set<std::string> names;
    for (const Callee* const callee : open)
        if (std::ranges::any_of(table.calls,
                                [&](const Call& call) { return call.callee == callee; }))
            names.insert(callee->name);
    return {names.begin(), names.end()};
}

/// Workers with equal answers to a call have the same number; the reference's is 0.
std::vector<int> kinds_of_answers(const Table& table, std::size_t call, bool is_open) {
    std::vector<const Answer*> kinds = {&table.right[call]};
    std::vector<int> numbers;
    for (const auto& answers : table.mistaken) {
        const auto kind = std::ranges::find_if(kinds, [&](const Answer* known) {
            return !differ(table.calls[call], is_open, answers[call], *known);
        });
        numbers.push_back(int(kind - kinds.begin()));
        if (kind == kinds.end()) kinds.push_back(&answers[call]);
    }
    return numbers;
}

/// Greedy: always the call that separates most of the remaining pairs, the plainest of these.
std::set<std::size_t> chosen(const Table& table, const Probes& probes_of_stage) {
    const std::size_t count = table.mistaken.size();
    std::vector<std::vector<int>> kinds;
    for (std::size_t i = 0; i < table.calls.size(); ++i)
        kinds.push_back(kinds_of_answers(table, i, is_compared_by_kind(*table.calls[i].callee)));
    std::vector<int> wanted(count, times_separated);
    std::vector<std::vector<bool>> apart(count, std::vector<bool>(count));
    std::set<std::size_t> probes;
    while (probes.size() < most_probes) {
        const auto gain = [&](std::size_t call) {
            int sum = 0;
            for (std::size_t i = 0; i < count; ++i) {
                if (kinds[call][i] != 0 && wanted[i] > 0) sum += 4;
                for (std::size_t j = 0; j < i; ++j)
                    if (kinds[call][i] != kinds[call][j] && !apart[i][j]) ++sum;
            }
            return sum;
        };
        std::size_t best = 0;
        int most = 0;
        for (std::size_t call = 0; call < kinds.size(); ++call) {
            if (probes.contains(call)) continue;
            if (const int sum = gain(call); sum > most) {
                most = sum;
                best = call;
            }
        }
        if (most == 0) break;
        probes.insert(best);
        for (std::size_t i = 0; i < count; ++i) {
            if (kinds[best][i] != 0) --wanted[i];
            for (std::size_t j = 0; j < i; ++j)
                if (kinds[best][i] != kinds[best][j]) apart[i][j] = true;
        }
    }
    for (const Callee& callee : callees()) {
        int left = is_open(probes_of_stage, callee) ? calls_of_open : calls_of_each;
        for (const std::size_t probe : probes) left -= table.calls[probe].callee == &callee ? 1 : 0;
        for (std::size_t call = 0; call < table.calls.size() && left > 0; ++call)
            if (table.calls[call].callee == &callee && probes.insert(call).second) --left;
    }
    return probes;
}

struct Request {
    std::string reports;
    std::string reference;
    Answers answers;
    std::string suite;
};

Probes choose(const Request& request) {
    const int stage = find_stage(request.answers.stage).value();
    const std::string record = content_of(request.reports + "/record");
    Table table{.calls = recorded(record, stage)};
    table.right = Asked(request.reference)(table.calls);
    Probes probes{.stage = stage};
    probes.cases = cases_of(record, content_of(request.reports + "/reference.report"), stage);
    probes.open = take_out_open(table, request.answers);
    for (const KnownMistake& known : request.answers.mistakes()) {
        const CaseResults results = Answers::results(
            request.suite, known.name, request.reports + "/" + known.name + ".report");
        Mistake mistake{.name = known.name, .sentence = known.sentence};
        for (const SuiteCase& each : probes.cases) {
            const auto result = results.find(each.name);  // none after a crash
            mistake.fails.push_back(result == results.end() || !result->second);
        }
        probes.mistakes.push_back(mistake);
        table.mistaken.push_back(request.answers.as(known.name)(table.calls));
    }
    for (const std::size_t call : chosen(table, probes))
        probes.probes.push_back({.call = table.calls[call], .right = table.right[call]});
    // Again, in this order: a mistake's answer may depend on earlier calls.
    std::vector<Call> calls;
    for (const Probe& probe : probes.probes) calls.push_back(probe.call);
    for (const Mistake& mistake : probes.mistakes) {
        const std::vector<Answer> answers = request.answers.as(mistake.name)(calls);
        for (std::size_t i = 0; i < answers.size(); ++i)
            probes.probes[i].mistaken.push_back(answers[i]);
    }
    return probes;
}

}  // namespace

}  // namespace rt::contract

int main(int argc, char** argv) {
    try {
        const std::vector<std::string> words(argv + 1, argv + argc);
        std::cout << text_of(
            rt::contract::choose({.reports = words.at(0),
                                  .reference = words.at(3),
                                  .answers = {words.at(1), words.at(2), words.at(4)},
                                  .suite = words.at(5)}));
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
