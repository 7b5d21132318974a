#include "common/contract/smallest.hpp"

#include "common/contract/call.hpp"

#include <algorithm>
#include <array>
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

namespace {

bool is_unit(Vec3 v) {
    return std::abs(dot(v, v) - 1) < 1e-9;
}

bool orthonormal(const Value& basis) {
    const Vec3 x = vec3(basis.parts[0]);
    const Vec3 y = vec3(basis.parts[1]);
    const Vec3 z = vec3(basis.parts[2]);
    const Vec3 off = cross(x, y) - z;
    return is_unit(x) && is_unit(y) && dot(off, off) < 1e-18;
}

bool is_coordinate(const std::string& name) {
    constexpr std::array lengths = {"radius", "height", "side",       "scale",    "error",
                                    "ratio",  "mirror", "brightness", "specular", "shininess"};
    return !name.empty() && std::ranges::find(lengths, name) == lengths.end();
}

bool keeps(const Value& value, const Value& before, const std::string& name) {
    if (value.type != before.type) return true;  // something was left out before it
    if (is_basis(value)) return !orthonormal(before) || orthonormal(value);
    if (value.type == &type_of<Interval>()) {
        const auto [min, max] = std::pair(value.parts[0].number, value.parts[1].number);
        return min >= 0 && min < max;
    }
    if (value.type == &type_of<BoundingBox>()) {
        const Vec3 size = vec3(value.parts[1]) - vec3(value.parts[0]);
        return size.x > 0 && size.y > 0 && size.z > 0;
    }
    if (is_vec3(value)) {
        if (is_place(name)) return true;
        const Vec3 v = vec3(value);
        const bool was_unit = is_unit(vec3(before)) && name != "direction";
        return was_unit ? is_unit(v) : dot(v, v) > 0 || dot(vec3(before), vec3(before)) == 0;
    }
    if (value.type->kind == Type::Kind::integer) return value.number >= 0;
    // A single number: a length, an angle, a share.
    const bool alone = value.type->kind == Type::Kind::real;
    if (!alone || is_coordinate(name)) return true;
    if (before.number > 0 && !(value.number > 0)) return false;
    return !(before.number >= 0 && before.number <= 1) || (value.number >= 0 && value.number <= 1);
}

/// A pixel is one of its picture's.
bool in_picture(const Call& call) {
    const Value* pixel = nullptr;
    const Value* picture = nullptr;
    for (const Value& argument : call.arguments) {
        if (argument.type == &type_of<Pixel>()) pixel = &argument;
        if (argument.type == &type_of<Resolution>()) picture = &argument;
    }
    if (picture == nullptr || pixel == nullptr) return true;
    return pixel->parts[0].number < picture->parts[1].number &&
           pixel->parts[1].number < picture->parts[0].number;
}

}  // namespace

bool Conditions::hold(Call call) const {
    bool all = true;
    Call start = start_;
    std::vector<std::pair<Value*, std::string>> before;
    for_each_within(start, [&](Value& v, const std::string& name) {
        before.push_back({&v, name});
    });
    std::size_t i = 0;
    for_each_within(call, [&](Value& value, const std::string& name) {
        if (i < before.size()) all = all && keeps(value, *before[i].first, name);
        ++i;
    });
    return all && (i == before.size() || !start_.arguments.empty()) && in_picture(call);
}

bool is_free(const Callee& callee) {
    constexpr std::array bound = {"normal",     "barycentric",         "square_uv",
                                  "reflected",  "interpolated_normal", "mirrored",
                                  "shadow_ray", "unprojected_ray"};
    return std::ranges::find(bound, callee.name) == bound.end();
}

}  // namespace rt::contract
