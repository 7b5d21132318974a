// Any value that crosses a contract, as a tree: for programs that compare, shorten and tell calls
// of every function alike.
#pragma once

#include "tests/contract/bytes.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt::contract {

/// What a value is made of, known when the program runs.
struct Type {
    enum class Kind { real, integer, truth, parts, sequence, optional, record };
    struct Part {
        const char* name;
        const Type* type;
    };

    Kind kind;
    const char* name = "";
    std::vector<Part> parts = {};  ///< one, if all are alike
    int count = 0;                 ///< of parts that are alike
    bool is_signed = true;
};

template <class T>
const Type& type_of();

template <class T>
Type make_type() {
    using Kind = Type::Kind;
    if constexpr (std::is_same_v<T, Real>) return {.kind = Kind::real};
    if constexpr (std::is_same_v<T, bool>) return {.kind = Kind::truth};
    if constexpr (std::is_integral_v<T>) {
        static_assert(std::is_same_v<T, bool> || sizeof(T) == 4);
        return {.kind = Kind::integer, .is_signed = std::is_signed_v<T>};
    }
    if constexpr (is_optional<T>)
        return {.kind = Kind::optional, .parts = {{"", &type_of<typename T::value_type>()}}};
    if constexpr (is_sequence<T>)
        return {.kind = Kind::sequence, .parts = {{"", &type_of<typename T::value_type>()}}};
    if constexpr (is_record<T>) {
        Type type{.kind = Kind::record, .name = record<T>.name};
        std::apply(
            [&]<class... Parts>(const Field<T, Parts>&... fields) {
                (type.parts.push_back({fields.name, &type_of<Parts>()}), ...);
            },
            record<T>.fields);
        return type;
    }
    if constexpr (part_count < T >> 0) {
        using Part = std::decay_t<decltype(std::declval<T>()[0])>;
        return {.kind = Kind::parts, .parts = {{"", &type_of<Part>()}}, .count = part_count<T>};
    }
}

template <class T>
const Type& type_of() {
    static const Type type = make_type<T>();
    return type;
}

struct Value {
    const Type* type = nullptr;
    double number = 0;         ///< of what has no parts
    std::vector<Value> parts;  ///< of an optional value: itself, or none
};

[[nodiscard]] Value get_value(const Type& type, Reader& from);
void put_value(Writer& to, const Value& value);

/// C++ that makes the value again. Answers are the same everywhere to some 14 digits.
[[nodiscard]] std::string code(const Value& value, int digits = 0);
/// What code has written, taken from the text's beginning. Throws Malformed.
[[nodiscard]] Value read_value(const Type& type, std::string_view& text);

/// Whether the suites would take one for the other: within the kit's `tolerance`, or another one.
/// NaN is NaN, and an optional t has no smaller scale than itself.
[[nodiscard]] bool same(const Value& came, const Value& expected, double within);

/// Calls visit(number's value) for each.
template <class SomeValue, class Visit>
void for_each_number(SomeValue& value, Visit visit) {
    using Kind = Type::Kind;
    const Kind kind = value.type->kind;
    if (kind == Kind::real || kind == Kind::integer || kind == Kind::truth) visit(value);
    for (auto& part : value.parts) for_each_number(part, visit);
}

/// The part of that name; nothing if there is none.
[[nodiscard]] const Value* find(const Value& value, std::string_view name);

[[nodiscard]] bool is_vec3(const Value& value);
[[nodiscard]] Vec3 vec3(const Value& value);
void set_vec3(Value& value, Vec3 v);

}  // namespace rt::contract
