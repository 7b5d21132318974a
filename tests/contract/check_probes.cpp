// check_probes PROBES PROJECT STAGE REFERENCE ANSWERS SUITE < CASES
//
// Tests a stage's probes.txt against its known mistakes: each is recognized as itself, or as others
// with the same answers and failing cases; without its own sentence, none is certainly another one
// with the same answers; of the cases that catch the mistakes of the stage, each fails those of its
// record and no others; and the reference and the other right answers are not recognized as a
// mistake. SUITE is the suite, linked to the known mistakes. Its cases, one a line, are those of
// probes.txt. Prints the recognized mistakes.
#include "common/contract/difference_texts.hpp"
#include "common/contract/probes.hpp"
#include "common/contract/recognition.hpp"
#include "common/contract/smallest.hpp"

#include "tests/contract/answers.hpp"

#include <algorithm>
#include <iostream>
#include <set>
#include <string_view>

namespace rt::contract {

namespace {

class Check {
public:
    Check(Probes probes, std::string reference)
        : probes_(std::move(probes)), reference_(std::move(reference)) {
        for (const Probe& probe : probes_.probes) calls_.push_back(probe.call);
    }

    void right(const std::string& name, Asked asked) {
        const std::vector<Answer> answers = asked(calls_);
        for (const auto& [mistake, is_certain] : recognized(probes_, answers, {}))
            complain(name + " is right, but recognized as " + mistake.name);
        Asked reference(reference_);
        if (const auto found = smallest_difference(probes_, answers, asked, reference))
            complain(name + " is right, but differs:\n  " +
                     paste_line(found->call, *found->expected.value) +
                     "\n  got: " + answer_text(found->call, found->got));
    }

    void mistaken(const std::string& name, const std::string& sentence, Asked asked) {
        const auto known = std::ranges::find(probes_.mistakes, name, &Mistake::name);
        if (known == probes_.mistakes.end()) return complain("there is nothing about " + name);
        if (known->sentence != sentence) complain("the sentence of " + name + " has changed");
        ++count_;
        if (!is_recognisable(probes_, name)) {
            std::cout << name << ": as near to the reference as right answers are\n";
            return;
        }
        bool as_itself = false;
        std::string names;
        const std::vector<Answer> answers = asked(calls_);
        for (const auto& [mistake, is_certain] : recognized(probes_, answers, results_of(*known))) {
            as_itself = as_itself || mistake.sentence == sentence;
            names += " " + mistake.name;
        }
        std::cout << name << ":" << names << '\n';
        for (const auto& [other, is_certain] :
             recognized(without(sentence), answers, results_of(*known))) {
            if (!is_certain) std::cout << "  probably " << other.name << ", if it were not known\n";
            if (is_certain && answers_are_of(other.name, answers))
                complain(name + " would have the name of " + other.name);
        }
        // In an open function, several may have the same failing cases: then none is named.
        // A constant function, and two mistakes with the same answers but other cases, have none.
        const bool is_constant_there = std::ranges::any_of(callees(), [&](const Callee& callee) {
            return callee.stage == probes_.stage && is_constant(probes_, answers, callee);
        });
        if (!as_itself && !(names.empty() && (!probes_.open.empty() || is_constant_there)))
            complain(name + " is not recognized");
    }

    /// The names of the suite's cases.
    void cases(std::istream& names) {
        std::size_t count = 0;
        for (std::string name; std::getline(names, name); ++count)
            if (count >= probes_.cases.size() || probes_.cases[count].name != name)
                return complain("not a case of probes.txt, in this order: " + name);
        if (count != probes_.cases.size())
            complain("probes.txt contains more cases than the suite");
    }

    /// Each mistake fails the cases of its record, of those that catch one of the stage.
    void records(const Answers& answers, const std::string& suite) {
        std::set<std::string> names;
        for (const KnownMistake& each : answers.mistakes()) names.insert(escaped(each.caught_by));
        std::string catching;
        for (const std::string& each : names) catching += each + ",";
        for (const Mistake& mistake : probes_.mistakes) {
            const CaseResults results =
                Answers::results(suite, mistake.name, answers.worker + ".report", {catching});
            for (std::size_t i = 0; i < mistake.fails.size(); ++i) {
                const auto found = results.find(probes_.cases[i].name);
                if (found != results.end() && found->second == mistake.fails[i])
                    complain(mistake.name + (found->second ? " passes " : " fails ") +
                             found->first + ", and its record in probes.txt does not");
            }
        }
    }

    [[nodiscard]] int end() {
        if (count_ != probes_.mistakes.size())
            complain("it contains mistakes that no longer exist");
        return failures_ == 0 ? 0 : 1;
    }

private:
    [[nodiscard]] CaseResults results_of(const Mistake& mistake) const {
        CaseResults results;
        for (std::size_t i = 0; i < mistake.fails.size(); ++i)
            results[probes_.cases[i].name] = !mistake.fails[i];
        return results;
    }

    [[nodiscard]] bool answers_are_of(const std::string& mistake,
                                      const std::vector<Answer>& answers) const {
        const auto place =
            std::ranges::find(probes_.mistakes, mistake, &Mistake::name) - probes_.mistakes.begin();
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (!same(answers[i], probes_.probes[i].mistaken[std::size_t(place)],
                      mistake_tolerance))
                return false;
        return true;
    }

    /// Without the mistakes that have this sentence.
    [[nodiscard]] Probes without(const std::string& sentence) const {
        Probes others = probes_;
        for (std::size_t i = others.mistakes.size(); i-- > 0;) {
            if (others.mistakes[i].sentence != sentence) continue;
            others.mistakes.erase(others.mistakes.begin() + std::ptrdiff_t(i));
            for (Probe& probe : others.probes)
                probe.mistaken.erase(probe.mistaken.begin() + std::ptrdiff_t(i));
        }
        return others;
    }

    /// The name of a case as Catch2 reads it.
    [[nodiscard]] static std::string escaped(const std::string& name) {
        std::string text;
        for (const char each : name) {
            if (std::string_view("[],*\\~").find(each) != std::string_view::npos) text += '\\';
            text += each;
        }
        return text;
    }

    void complain(const std::string& what) {
        std::cout << "error: " << what << '\n';
        ++failures_;
    }

    Probes probes_;
    std::string reference_;
    std::vector<Call> calls_;
    std::size_t count_ = 0;
    int failures_ = 0;
};

int check(const std::vector<std::string>& words) {
    const std::string& reference = words.at(3);
    const Answers answers{words.at(1), words.at(2), words.at(4)};
    Check check(read_probes(content_of(words.at(0))), reference);
    check.cases(std::cin);
    check.right("the reference", Asked(reference));
    for (const std::string& name : answers.alternatives()) check.right(name, answers.as(name));
    for (const KnownMistake& known : answers.mistakes())
        check.mistaken(known.name, known.sentence, answers.as(known.name));
    check.records(answers, words.at(5));
    return check.end();
}

}  // namespace

}  // namespace rt::contract

int main(int argc, char** argv) {
    try {
        return rt::contract::check({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 2;
    }
}
