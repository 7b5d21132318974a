#include "common/contract/smallest.hpp"

#include "common/contract/conditions.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace rt::contract {

namespace {

constexpr int neighbors_of_each = 8;  ///< calls like a probe
constexpr int most_starts = 6;        ///< from which the search for a plain call starts
constexpr int most_questions = 4000;  ///< for each start

/// Searches for a difference, by sending each call to both workers.
class Search {
public:
    Search(Asked& student, Asked& reference) : student_(student), reference_(reference) {}

    [[nodiscard]] std::optional<Difference> difference(const Call& call) {
        ++questions_;
        const Answer expected = reference_(call);
        Difference difference{.call = call, .got = student_(call), .expected = expected};
        if (!expected.value || !difference.got.asked() ||
            same(difference.got, expected, right_tolerance))
            return std::nullopt;
        return difference;
    }

    /// The same as `difference`, but for a call that no suite has made: another right answer,
    /// rounded differently, must be equally near. So the answer must hardly change with the call's
    /// numbers.
    [[nodiscard]] std::optional<Difference> certain_difference(const Call& call) {
        auto found = difference(call);
        if (!found) return std::nullopt;
        const bool is_far = !same(found->got, found->expected, 1e-3);
        if (!is_far && !same_size(*found)) return std::nullopt;
        std::mt19937 random(1);
        for (int i = 0; i < 6; ++i) {
            ++questions_;
            if (!same(reference_(nudged(call, random)), found->expected, 1e-4)) return std::nullopt;
        }
        return found;
    }

    [[nodiscard]] Difference plainest(Difference difference) {
        const Conditions conditions(difference.call);
        questions_ = 0;
        for (bool changed = true; changed && questions_ < most_questions;) {
            changed = false;
            for (const Call& candidate : plainer_calls(difference.call)) {
                if (!(length_of(candidate) < length_of(difference.call))) continue;
                if (!conditions.hold(candidate)) continue;
                auto found = certain_difference(candidate);
                if (!found) continue;
                difference = *found;
                changed = true;
                break;
            }
        }
        return difference;
    }

    /// The same difference without the sign of a zero, unless that counts.
    [[nodiscard]] Difference without_signed_zeros(const Difference& found) {
        const auto plain = difference(contract::without_signed_zeros(found.call));
        return plain && plain->got.value.has_value() == found.got.value.has_value() ? *plain
                                                                                    : found;
    }

    /// The call with its numbers moved by some part of themselves.
    static Call moved_about(Call call, double part, std::mt19937& random) {
        for (Value& argument : call.arguments)
            for_each_number(argument, [&](Value& number) {
                if (number.type->kind != Type::Kind::real || !std::isfinite(number.number)) return;
                const double share = double(random()) / double(std::mt19937::max()) * 2 - 1;
                number.number += part * share * std::max(std::abs(number.number), 1.0);
            });
        return call;
    }

private:
    static Call nudged(const Call& call, std::mt19937& random) {
        return moved_about(call, 1e-6, random);
    }

    /// Small, but not a matter of rounding.
    static bool same_size(const Difference& difference) {
        return !same(difference.got, difference.expected, 1e-8);
    }

    Asked& student_;
    Asked& reference_;
    int questions_ = 0;
};

/// The order of failing calls: first the function that is first in the contract, then the plainest
/// numbers.
bool plainer(const Difference& a, const Difference& b) {
    const auto order = [](const Difference& difference) {
        return std::pair(difference.call.callee->place, length_of(difference.call));
    };
    return order(a) < order(b);
}

/// The probes, with one right answer each, that were answered differently.
std::vector<Difference> failed_probes(const Probes& probes, const std::vector<Answer>& answers) {
    std::vector<Difference> failed;
    for (std::size_t i = 0; i < probes.probes.size(); ++i) {
        const auto& [call, right, mistaken] = probes.probes[i];
        if (!answers[i].asked()) continue;
        // In an open function only a missing answer is certainly wrong.
        if (is_open(probes, *call.callee) ? !answers[i].value
                                          : !same(answers[i], right, right_tolerance))
            failed.push_back({.call = call, .got = answers[i], .expected = right});
    }
    return failed;
}

/// Wrong answers to calls near the probes, for a student's file that answers all probes right.
std::vector<Difference> failed_neighbors(const Probes& probes, Search& search) {
    std::vector<Difference> failed;
    std::mt19937 random(2021);
    for (const Probe& probe : probes.probes) {
        if (is_open(probes, *probe.call.callee) || !is_free(*probe.call.callee)) continue;
        const Conditions conditions(probe.call);
        for (int i = 0; i < neighbors_of_each; ++i) {
            const Call other = Search::moved_about(probe.call, 0.25, random);
            if (!conditions.hold(other)) continue;
            if (auto found = search.certain_difference(other)) failed.push_back(*found);
        }
    }
    return failed;
}

}  // namespace

std::optional<Difference> smallest_difference(const Probes& probes,
                                              const std::vector<Answer>& answers, Asked& student,
                                              Asked& reference, const std::vector<Call>& failing) {
    Search search(student, reference);
    std::vector<Difference> failed;
    for (const Call& call : failing)
        if (const auto found = search.difference(call);
            found && (!is_open(probes, *call.callee) || !found->got.value))
            failed.push_back(*found);
    if (failed.empty()) failed = failed_probes(probes, answers);
    if (failed.empty()) failed = failed_neighbors(probes, search);
    if (failed.empty()) return std::nullopt;
    std::ranges::sort(failed, plainer);
    Difference smallest = failed.front();
    const Callee* const callee = smallest.call.callee;
    if (!is_free(*callee) || is_open(probes, *callee)) return search.without_signed_zeros(smallest);
    // One simplification may block another that leads to a plainer call, so several starts are
    // tried.
    int starts = 0;
    for (const Difference& difference : failed) {
        if (difference.call.callee != callee || starts == most_starts) break;
        const auto certain = search.certain_difference(difference.call);
        if (!certain) continue;
        ++starts;
        Difference found = search.plainest(*certain);
        if (starts == 1 || plainer(found, smallest)) smallest = std::move(found);
    }
    return search.without_signed_zeros(smallest);
}

}  // namespace rt::contract
