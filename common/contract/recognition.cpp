#include "common/contract/recognition.hpp"

#include "common/contract/probes.hpp"

#include <algorithm>
#include <set>
#include <tuple>

namespace rt::contract {

namespace {

using Functions = std::set<const Callee*>;

// Chosen such that no known mistake has the name of another one if its own record is taken away
// (check_probes).
constexpr double least_of_wrong = 0.8;   ///< of the wrong answers, those that are the mistake's
constexpr double least_likeness = 0.75;  ///< of answers
constexpr double least_of_cases = 0.6;   ///< likeness of failing cases
constexpr double cases_of_open = 0.5;    ///< if all answers of an open function are alike
constexpr int least_values = 2;          ///< answers that few mistakes share
constexpr double most_alien = 0.25;      ///< of these, numbers that another formula gives
constexpr int least_misses = 5;          ///< of a mistake that gives no numbers
constexpr double misses_alike = 0.85;    ///< likeness of its answers
constexpr double most_of_open = 0.7;     ///< where a formula cancels, answers are of another kind

/// The comparison of a function's answers with a mistake's.
struct Fit {
    int probes = 0;
    int alike = 0;    ///< answers that are the mistake's, right ones among them
    int wrong = 0;    ///< answers that are not the reference's
    int errs = 0;     ///< probes on which the mistake errs
    int both = 0;     ///< of these, those on which the answer is wrong
    int hits = 0;     ///< of these, those with the mistake's answer
    int values = 0;   ///< of these, those with a number that few mistakes share
    int numbers = 0;  ///< probes on which the mistake errs with such a number
    int alien = 0;    ///< wrong answers with a number that is not the mistake's

    [[nodiscard]] bool is_exact() const { return wrong > 0 && alike == probes; }
    /// The share of the mistake's answers among all on which either errs.
    [[nodiscard]] double likeness() const {
        return hits == 0 ? 0 : double(hits) / double(wrong + errs - both);
    }
    [[nodiscard]] bool is_near() const {
        const bool by_values = values >= least_values && likeness() >= least_likeness;
        const bool by_misses = numbers == 0 && hits >= least_misses && likeness() >= misses_alike;
        return (by_values || by_misses) && hits >= least_of_wrong * wrong &&
               alien <= most_alien * (by_values ? values : hits);
    }
};

/// True if the answer contains a number other than 0, 1 and −1.
bool is_value(const Answer& answer) {
    if (!answer.value) return false;
    bool found = false;
    for_each_number(*answer.value, [&](const Value& each) {
        found =
            found || (std::isfinite(each.number) && each.number != 0 && std::abs(each.number) != 1);
    });
    return found;
}

/// A mistake and the functions whose answers it explains.
struct Candidate {
    std::size_t mistake;
    Functions functions = {};
    bool is_certain = true;
    double likeness = 0;

    [[nodiscard]] auto rank() const { return std::tuple(is_certain, functions.size(), likeness); }
};

class Recognition {
public:
    Recognition(const Probes& probes, const std::vector<Answer>& answers,
                const CaseResults& results)
        : probes_(probes), answers_(answers), results_(results) {
        for (const Callee& callee : callees())
            if (callee.stage == probes.stage && is_wrong(callee)) wrong_.insert(&callee);
    }

    /// The candidates that explain most, and then those that explain what is left. Where a mistake
    /// errs that is certain, no other one is likely: it is the cause there, too.
    [[nodiscard]] std::vector<Recognized> found() const {
        std::vector<Candidate> candidates;
        for (std::size_t i = 0; i < probes_.mistakes.size(); ++i)
            if (Candidate each = explained_by(i); !each.functions.empty())
                candidates.push_back(std::move(each));
        std::vector<Recognized> all;
        Functions left = wrong_;
        Functions explained_for_certain;
        while (!candidates.empty()) {
            for (Candidate& each : candidates)
                std::erase_if(each.functions, [&](auto* callee) {
                    return !left.contains(callee) ||
                           (!each.is_certain && explained_for_certain.contains(callee));
                });
            std::erase_if(candidates, [](const Candidate& each) { return each.functions.empty(); });
            for (const Candidate& each : best_of(candidates)) {
                for (const Callee* const callee : each.functions) left.erase(callee);
                if (each.is_certain) add_functions_of(each.mistake, explained_for_certain);
                all.push_back({probes_.mistakes[each.mistake], each.is_certain});
            }
            if (candidates.empty()) break;
            const Functions explained =
                std::ranges::max_element(candidates, {}, &Candidate::rank)->functions;
            for (const Callee* const callee : explained) left.erase(callee);
        }
        for (const Callee* const callee : left) {
            if (explained_for_certain.contains(callee)) continue;
            for (const std::size_t mistake : two_in(*callee))
                all.push_back({probes_.mistakes[mistake], false});
        }
        return all;
    }

private:
    void add_functions_of(std::size_t mistake, Functions& functions) const {
        for (const Callee& callee : callees())
            if (callee.stage == probes_.stage && errs_in(mistake, callee))
                functions.insert(&callee);
    }

    [[nodiscard]] bool alike(const Probe& probe, const Answer& a, const Answer& b) const {
        return is_compared_by_kind(*probe.call.callee) && is_open(probes_, *probe.call.callee)
                   ? same_kind(probe.call, a, b)
                   : same(a, b, mistake_tolerance);
    }
    [[nodiscard]] bool differs(const Probe& probe, const Answer& answer) const {
        return is_compared_by_kind(*probe.call.callee) && is_open(probes_, *probe.call.callee)
                   ? !same_kind(probe.call, answer, probe.right)
                   : !same(answer, probe.right, right_tolerance);
    }
    template <class Visit>
    void for_each_probe(const Callee& callee, Visit visit) const {
        for (std::size_t i = 0; i < answers_.size(); ++i)
            if (probes_.probes[i].call.callee == &callee) visit(probes_.probes[i], answers_[i]);
    }

    /// An answer of an open function may be wrong though it is of a right kind.
    [[nodiscard]] bool is_wrong(const Callee& callee) const {
        bool wrong = is_open(probes_, callee) && !results_.empty();
        for_each_probe(callee, [&](const Probe& probe, const Answer& answer) {
            wrong = wrong || differs(probe, answer);
        });
        return wrong;
    }

    [[nodiscard]] Fit fit(std::size_t mistake, const Callee& callee) const {
        Fit fit;
        for_each_probe(callee, [&](const Probe& probe, const Answer& answer) {
            const Answer& expected = probe.mistaken[mistake];
            const bool is_alike = alike(probe, answer, expected);
            const bool is_wrong = differs(probe, answer);
            const bool errs = differs(probe, expected);
            ++fit.probes;
            fit.alike += is_alike;
            fit.wrong += is_wrong;
            fit.errs += errs;
            fit.both += errs && is_wrong;
            fit.hits += errs && is_wrong && is_alike;
            fit.values += errs && is_wrong && is_alike && is_value(answer);
            fit.numbers += errs && is_value(expected);
            fit.alien += is_wrong && !is_alike && is_value(answer);
        });
        return fit;
    }

    /// Two mistakes that together give all wrong answers of the function, each of them some alone;
    /// where both err, the answer may be another one. The one that gives more of them comes first.
    /// Nothing if there is no such pair, or a second one with other sentences.
    [[nodiscard]] std::vector<std::size_t> two_in(const Callee& callee) const {
        std::vector<std::size_t> found;
        if (is_open(probes_, callee) || is_constant(probes_, answers_, callee)) return found;
        const auto sentence = [&](std::size_t i) { return probes_.mistakes[i].sentence; };
        for (std::size_t i = 0; i < probes_.mistakes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                if (sentence(i) == sentence(j) || !explain_together(callee, i, j)) continue;
                if (found.empty())
                    found = {j, i};
                else if (std::set{sentence(i), sentence(j)} !=
                         std::set{sentence(found[0]), sentence(found[1])})
                    return {};
            }
        if (!found.empty() && fit(found[0], callee).hits < fit(found[1], callee).hits)
            std::swap(found[0], found[1]);
        return found;
    }

    [[nodiscard]] bool explain_together(const Callee& callee, std::size_t i, std::size_t j) const {
        constexpr int least_alone = 2;
        int alone_i = 0;
        int alone_j = 0;
        int values = 0;
        bool all = true;
        for_each_probe(callee, [&](const Probe& probe, const Answer& answer) {
            const bool errs_i = differs(probe, probe.mistaken[i]);
            const bool errs_j = differs(probe, probe.mistaken[j]);
            const bool is_i = alike(probe, answer, probe.mistaken[i]);
            const bool is_j = alike(probe, answer, probe.mistaken[j]);
            all = all && (is_i || is_j || (errs_i && errs_j)) && (errs_i || errs_j || is_i) &&
                  (differs(probe, answer) || errs_i == errs_j);
            alone_i += errs_i && is_i && !is_j;
            alone_j += errs_j && is_j && !is_i;
            values += (errs_i || errs_j) && (is_i || is_j) && is_value(answer);
        });
        return all && alone_i >= least_alone && alone_j >= least_alone && values >= least_values;
    }

    /// The functions in which the mistake can be made. Last digits count in an open function, in
    /// which it may also be another right answer: then it fails no case of that function.
    [[nodiscard]] bool errs_in(std::size_t mistake, const Callee& callee) const {
        if (is_open(probes_, callee) && !fails_a_case_of(mistake, callee)) return false;
        const double within = is_open(probes_, callee) ? 0 : right_tolerance;
        return std::ranges::any_of(probes_.probes, [&](const Probe& probe) {
            return probe.call.callee == &callee &&
                   !same(probe.mistaken[mistake], probe.right, within);
        });
    }

    /// Cases that call every function of the stage, as pictures do, do not count.
    [[nodiscard]] bool fails_a_case_of(std::size_t mistake, const Callee& callee) const {
        const auto functions =
            std::size_t(std::ranges::count(callees(), probes_.stage, &Callee::stage));
        const std::vector<bool>& fails = probes_.mistakes[mistake].fails;
        for (std::size_t i = 0; i < fails.size(); ++i) {
            const auto& calls = probes_.cases[i].calls;
            if (fails[i] && calls.size() < functions &&
                std::ranges::find(calls, &callee) != calls.end())
                return true;
        }
        return functions == 1;
    }

    [[nodiscard]] Candidate explained_by(std::size_t mistake) const {
        Candidate candidate{.mistake = mistake};
        Functions spared;
        bool open = false;
        bool near = true;
        for (const Callee& callee : callees()) {
            if (callee.stage != probes_.stage || !errs_in(mistake, callee)) continue;
            const Fit fitting = fit(mistake, callee);
            if (is_open(probes_, callee)) {
                if (results_.empty()) continue;
                const double least = is_compared_by_kind(callee) ? most_of_open : 1;
                const bool by_kind = fitting.alike >= least * fitting.probes;
                if (!by_kind && !fitting.is_near()) continue;
                candidate.is_certain = candidate.is_certain && fitting.alike == fitting.probes;
                open = true;
                near = near && fitting.is_near();
            } else if (fitting.wrong == 0) {
                spared.insert(&callee);
                continue;
            } else if (is_constant(probes_, answers_, callee) ||
                       !(fitting.is_exact() || fitting.is_near())) {
                continue;
            } else {
                candidate.is_certain = candidate.is_certain && fitting.is_exact();
            }
            candidate.functions.insert(&callee);
            candidate.likeness += fitting.likeness();
        }
        if (candidate.functions.empty()) return candidate;
        candidate.likeness /= double(candidate.functions.size());
        const double cases = likeness_of_cases(candidate, spared);
        // An open function's answers of the mistake's kind may be right: then all cases decide.
        const double least = !open                  ? least_of_cases
                             : !near                ? 1
                             : candidate.is_certain ? cases_of_open
                                                    : least_of_cases;
        if (cases < least) candidate.functions.clear();
        candidate.is_certain = candidate.is_certain && cases == 1 && spared.empty();
        candidate.likeness += cases;
        return candidate;
    }

    /// The share of the cases that the answers and the mistake fail among those that either fails.
    /// Cases of another wrong function, and of one in which the mistake is not made, do not count.
    [[nodiscard]] double likeness_of_cases(const Candidate& candidate,
                                           const Functions& spared) const {
        const std::vector<bool>& fails = probes_.mistakes[candidate.mistake].fails;
        int either = 0;
        int both = 0;
        for (std::size_t i = 0; i < fails.size(); ++i) {
            const auto found = results_.find(probes_.cases[i].name);
            if (found == results_.end()) continue;
            const bool failed = !found->second;
            if (failed && !fails[i] && calls_any_but(probes_.cases[i], wrong_, candidate.functions))
                continue;
            if (!failed && fails[i] && calls_any_but(probes_.cases[i], spared, {})) continue;
            either += failed || fails[i];
            both += failed && fails[i];
        }
        return either == 0 ? results_.empty() : double(both) / double(either);
    }

    [[nodiscard]] static bool calls_any_but(const SuiteCase& each, const Functions& functions,
                                            const Functions& but) {
        return std::ranges::any_of(each.calls, [&](const Callee* callee) {
            return functions.contains(callee) && !but.contains(callee);
        });
    }

    /// Those of the highest rank, one of each sentence: none if several are not certain.
    [[nodiscard]] std::vector<Candidate> best_of(const std::vector<Candidate>& candidates) const {
        std::vector<Candidate> best;
        std::set<std::string> sentences;
        for (const Candidate& each : candidates) {
            const bool is_best = std::ranges::none_of(
                candidates, [&](const Candidate& other) { return other.rank() > each.rank(); });
            if (is_best && sentences.insert(probes_.mistakes[each.mistake].sentence).second)
                best.push_back(each);
        }
        const bool open = std::ranges::any_of(best, [&](const Candidate& each) {
            return std::ranges::any_of(each.functions,
                                       [&](auto* callee) { return is_open(probes_, *callee); });
        });
        if (best.size() > 1 && (open || !best.front().is_certain)) return {};
        return best;
    }

    const Probes& probes_;
    const std::vector<Answer>& answers_;
    const CaseResults& results_;
    Functions wrong_;
};

}  // namespace

std::vector<Recognized> recognized(const Probes& probes, const std::vector<Answer>& answers,
                                   const CaseResults& results) {
    return Recognition(probes, answers, results).found();
}

bool is_constant(const Probes& probes, const std::vector<Answer>& answers, const Callee& callee) {
    std::set<std::string> right;
    std::set<std::string> got;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        if (probes.probes[i].call.callee != &callee) continue;
        right.insert(code(probes.probes[i].right));
        got.insert(code(answers[i]));
    }
    return right.size() > 1 && got.size() == 1;
}

}  // namespace rt::contract
