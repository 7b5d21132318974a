#include "common/contract/smallest.hpp"

#include "common/contract/call.hpp"

#include <cmath>

namespace rt::contract {

namespace {

/// The length of a number's text.
double length_of(double number) {
    const double size = std::abs(number);
    if (size == 0) return std::signbit(number) ? 0.25 : 0;
    if (std::isinf(size)) return 0;
    const double sign = number < 0 ? 0.5 : 0;
    if (size == 1) return 1 + sign;
    if (size == std::floor(size) && size <= 1e6) return 2 + std::log10(size) + sign;
    if (size * 8 == std::floor(size * 8) && size <= 1e6) return 4 + std::log10(1 + size) + sign;
    return 4 + double(code(Value{.type = &type_of<Real>(), .number = number}).size());
}

/// The part with this number in the order of for_each_within.
Value& part_of(Call& call, std::size_t place) {
    Value* found = nullptr;
    for_each_within(call, [&, i = std::size_t(0)](Value& v, const std::string&) mutable {
        if (i++ == place) found = &v;
    });
    return *found;
}

/// Collects changed copies of a call.
class Changes {
public:
    explicit Changes(const Call& call) : call_(call) {
        Call counted = call;
        for_each_within(counted, [&](Value& v, const std::string& name) {
            within_.push_back({v, name});
        });
    }

    /// A whole interval, the world's basis with any order of its axes, one triangle less.
    void leave_out() {
        for (std::size_t i = 0; i < within_.size(); ++i) {
            const auto& [value, name] = within_[i];
            if (value.type == &type_of<Interval>())
                add(i, [](Value& interval) {
                    interval.parts[0].number = 0;
                    interval.parts[1].number = double(infinity);
                });
            if (is_basis(value))
                for (std::size_t first = 0; first < 3; ++first)
                    add(i, [first](Value& basis) {
                        set_vec3(basis.parts[first], {1, 0, 0});
                        set_vec3(basis.parts[(first + 1) % 3], {0, 1, 0});
                        set_vec3(basis.parts[(first + 2) % 3], {0, 0, 1});
                    });
            if (value.type->kind == Type::Kind::sequence && name == "triangles")
                for (std::size_t j = 0; j < value.parts.size(); ++j)
                    add(i, [j](Value& triangles) {
                        triangles.parts.erase(triangles.parts.begin() + std::ptrdiff_t(j));
                    });
        }
    }

    /// A point moved to the origin with everything else, or a vector along an axis.
    void plain_vectors() {
        for (std::size_t i = 0; i < within_.size(); ++i) {
            const auto& [value, name] = within_[i];
            if (!is_vec3(value)) continue;
            if (is_place(name)) all_.push_back(moved(vec3(value)));
            for (const Vec3& axis : {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1),
                                     Vec3(-1, 0, 0), Vec3(0, -1, 0), Vec3(0, 0, -1)})
                add(i, [axis](Value& v) { set_vec3(v, axis); });
        }
    }

    void plain_numbers() {
        for (std::size_t i = 0; i < within_.size(); ++i) {
            const Value& value = within_[i].first;
            if (value.type->kind != Type::Kind::real && value.type->kind != Type::Kind::integer)
                continue;
            const double x = value.number;
            for (const double plain :
                 {0.0, 1.0, -1.0, 2.0, -2.0, 0.5, -0.5, 3.0, 4.0, std::round(x), std::floor(x),
                  std::ceil(x), std::round(2 * x) / 2, std::round(8 * x) / 8,
                  std::round(10 * x) / 10}) {
                if (value.type->kind == Type::Kind::integer && plain != std::floor(plain)) continue;
                add(i, [plain](Value& number) { number.number = plain; });
            }
        }
    }

    [[nodiscard]] std::vector<Call> all() { return std::move(all_); }

private:
    template <class Change>
    void add(std::size_t place, Change change) {
        all_.push_back(call_);
        change(part_of(all_.back(), place));
    }

    [[nodiscard]] Call moved(Vec3 middle) const {
        Call other = call_;
        for_each_within(other, [&](Value& v, const std::string& name) {
            if (is_vec3(v) && is_place(name)) set_vec3(v, vec3(v) - middle);
        });
        return other;
    }

    const Call& call_;
    std::vector<std::pair<Value, std::string>> within_;
    std::vector<Call> all_;
};

}  // namespace

double length_of(const Call& call) {
    double sum = 0;
    for (const Value& argument : call.arguments)
        for_each_number(argument,
                        [&](const Value& number) { sum += 1 + length_of(number.number); });
    return sum;
}

std::vector<Call> plainer_calls(const Call& call) {
    Changes changes(call);
    changes.leave_out();
    changes.plain_vectors();
    changes.plain_numbers();
    return changes.all();
}

Call without_signed_zeros(Call call) {
    for (Value& argument : call.arguments) argument = without_signed_zeros(argument);
    return call;
}

}  // namespace rt::contract
