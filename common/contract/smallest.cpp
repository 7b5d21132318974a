#include "common/contract/smallest.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace rt::contract {

namespace {

constexpr int neighbours_of_each = 8;  ///< calls like a probe
constexpr int most_starts = 6;         ///< from which the search for a plain call starts
constexpr int most_questions = 4000;   ///< for each start

/// The length of a number's text.
double length_of(double number) {
    const double size = std::abs(number);
    if (size == 0 || std::isinf(size)) return 0;
    const double sign = number < 0 ? 0.5 : 0;
    if (size == 1) return 1 + sign;
    if (size == std::floor(size) && size <= 1e6) return 2 + std::log10(size) + sign;
    if (size * 8 == std::floor(size * 8) && size <= 1e6) return 4 + std::log10(1 + size) + sign;
    return 4 + double(code(Value{.type = &type_of<Real>(), .number = number}).size());
}

double length_of(const Call& call) {
    double sum = 0;
    for (const Value& argument : call.arguments)
        for_each_number(argument,
                        [&](const Value& number) { sum += 1 + length_of(number.number); });
    return sum;
}

/// Calls visit(part, its name) for a value and all of its parts.
template <class Visit>
void for_each_within(Value& value, const std::string& name, Visit& visit) {
    visit(value, name);
    for (std::size_t i = 0; i < value.parts.size(); ++i) {
        const bool named = value.type->kind == Type::Kind::record;
        for_each_within(value.parts[i], named ? value.type->parts[i].name : name, visit);
    }
}

template <class Visit>
void for_each_within(Call& call, Visit visit) {  // the ones that may count
    for (Value& argument : call.arguments) for_each_within(argument, "", visit);
}

/// True for a point, false for a direction.
bool is_place(const std::string& name) {
    constexpr std::array places = {"origin", "center",   "point",    "apex",        "a",   "b",
                                   "c",      "position", "vertices", "translation", "min", "max"};
    return std::ranges::find(places, name) != places.end();
}

bool is_unit(Vec3 v) {
    return std::abs(dot(v, v) - 1) < 1e-9;
}

bool is_basis(const Value& value) {
    return value.type == &type_of<Basis>();
}

bool orthonormal(const Value& basis) {
    const Vec3 x = vec3(basis.parts[0]);
    const Vec3 y = vec3(basis.parts[1]);
    const Vec3 z = vec3(basis.parts[2]);
    const Vec3 off = cross(x, y) - z;
    return is_unit(x) && is_unit(y) && dot(off, off) < 1e-18;
}

/// The conditions of its contract that a plainer call must keep: unit lengths stay unit, positive
/// numbers stay positive, and shares stay between 0 and 1.
class Conditions {
public:
    explicit Conditions(Call call) : start_(std::move(call)) {}

    [[nodiscard]] bool hold(Call call) const {
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

private:
    static bool keeps(const Value& value, const Value& before, const std::string& name) {
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
        return !(before.number >= 0 && before.number <= 1) ||
               (value.number >= 0 && value.number <= 1);
    }

    static bool is_coordinate(const std::string& name) {
        constexpr std::array lengths = {"radius", "height", "side",       "scale",    "error",
                                        "ratio",  "mirror", "brightness", "specular", "shininess"};
        return !name.empty() && std::ranges::find(lengths, name) == lengths.end();
    }

    /// A pixel is one of its picture's.
    static bool in_picture(const Call& call) {
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

    Call start_;
};

/// True if a call's arguments are independent. The point of a normal is on the shape, and the point
/// of a weight is in the triangle's plane: those must change together.
bool is_free(const Callee& callee) {
    constexpr std::array bound = {"normal",     "barycentric",         "square_uv",
                                  "reflected",  "interpolated_normal", "mirrored",
                                  "shadow_ray", "unprojected_ray"};
    return std::ranges::find(bound, callee.name) == bound.end();
}

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
            for (const Call& candidate : candidates(difference.call)) {
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

    /// The call with less in it, or with one of its numbers plainer: large steps first.
    static std::vector<Call> candidates(const Call& call) {
        std::vector<Call> all;
        const auto changed = [&](auto change) {
            Call other = call;
            change(other);
            all.push_back(std::move(other));
        };
        Call counted = call;
        std::vector<std::pair<Value, std::string>> within;
        for_each_within(counted, [&](Value& v, const std::string& name) {
            within.push_back({v, name});
        });
        const auto at = [](Call& other, std::size_t place) -> Value& {
            Value* found = nullptr;
            for_each_within(other, [&, i = std::size_t(0)](Value& v, const std::string&) mutable {
                if (i++ == place) found = &v;
            });
            return *found;
        };
        for (std::size_t i = 0; i < within.size(); ++i) {
            const auto& [value, name] = within[i];
            if (value.type == &type_of<Interval>())
                changed([&](Call& c) {
                    at(c, i).parts[0].number = 0;
                    at(c, i).parts[1].number = double(infinity);
                });
            if (is_basis(value))  // the world's basis, with any order of its axes
                for (std::size_t first = 0; first < 3; ++first)
                    changed([&](Call& c) {
                        set_vec3(at(c, i).parts[first], {1, 0, 0});
                        set_vec3(at(c, i).parts[(first + 1) % 3], {0, 1, 0});
                        set_vec3(at(c, i).parts[(first + 2) % 3], {0, 0, 1});
                    });
            if (value.type->kind == Type::Kind::sequence && name == "triangles")
                for (std::size_t j = 0; j < value.parts.size(); ++j)
                    changed([&](Call& c) {
                        auto& parts = at(c, i).parts;
                        parts.erase(parts.begin() + std::ptrdiff_t(j));
                    });
        }
        for (std::size_t i = 0; i < within.size(); ++i) {
            const auto& [value, name] = within[i];
            if (is_vec3(value) && is_place(name))  // everything moved, so that this is the origin
                changed([&](Call& c) {
                    const Vec3 middle = vec3(at(c, i));
                    for_each_within(c, [&](Value& v, const std::string& its_name) {
                        if (is_vec3(v) && is_place(its_name)) set_vec3(v, vec3(v) - middle);
                    });
                });
            if (is_vec3(value))
                for (const Vec3& axis : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
                                         Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)})
                    changed([&](Call& c) { set_vec3(at(c, i), axis); });
        }
        for (std::size_t i = 0; i < within.size(); ++i) {
            const Value& value = within[i].first;
            if (!value.parts.empty() || value.type->kind == Type::Kind::truth) continue;
            if (value.type->kind == Type::Kind::sequence ||
                value.type->kind == Type::Kind::optional)
                continue;
            const double x = value.number;
            for (const double rounder :
                 {0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 3.0, 4.0, std::round(x), std::floor(x),
                  std::ceil(x), std::round(2 * x) / 2, std::round(8 * x) / 8,
                  std::round(10 * x) / 10}) {
                if (value.type->kind == Type::Kind::integer && rounder != std::floor(rounder))
                    continue;
                changed([&](Call& c) { at(c, i).number = rounder; });
            }
        }
        return all;
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
        if (is_open(probes, *call.callee) || !answers[i].asked()) continue;
        if (!same(answers[i], right, right_tolerance))
            failed.push_back({.call = call, .got = answers[i], .expected = right});
    }
    return failed;
}

/// Calls near the probes, for whoever answers all these right.
std::vector<Difference> failed_neighbours(const Probes& probes, Search& search) {
    std::vector<Difference> failed;
    std::mt19937 random(2021);
    for (const Probe& probe : probes.probes) {
        if (is_open(probes, *probe.call.callee) || !is_free(*probe.call.callee)) continue;
        const Conditions conditions(probe.call);
        for (int i = 0; i < neighbours_of_each; ++i) {
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
                                              Asked& reference) {
    Search search(student, reference);
    std::vector<Difference> failed = failed_probes(probes, answers);
    if (failed.empty()) failed = failed_neighbours(probes, search);
    if (failed.empty()) return std::nullopt;
    std::ranges::sort(failed, plainer);
    Difference smallest = failed.front();
    const Callee* const callee = smallest.call.callee;
    if (!is_free(*callee)) return smallest;
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
    return smallest;
}

}  // namespace rt::contract
