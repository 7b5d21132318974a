// Any value in a contract, as a tree: for programs that compare, simplify and print calls of every
// function.
#pragma once

#include "common/contract/bytes.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::contract {

/// The structure of a value, at run time.
struct Type {
    enum class Kind { real, integer, truth, parts, sequence, optional, record };
    struct Part {
        const char* name;
        const Type* type;
    };

    Kind kind;
    const char* name = "";
    std::vector<Part> parts = {};  ///< one, if all are alike
    int count = 0;                 ///< of equal parts
    bool is_signed = true;
};

template <class T>
const Type& type_of();

template <class T>
Type make_type() {
    using Kind = Type::Kind;
    if constexpr (std::is_same_v<T, Real>) {
        return {.kind = Kind::real};
    } else if constexpr (std::is_same_v<T, bool>) {
        return {.kind = Kind::truth};
    } else if constexpr (std::is_integral_v<T>) {
        static_assert(sizeof(T) == 4);
        return {.kind = Kind::integer, .is_signed = std::is_signed_v<T>};
    } else if constexpr (is_optional<T>) {
        return {.kind = Kind::optional, .parts = {{"", &type_of<typename T::value_type>()}}};
    } else if constexpr (is_sequence<T>) {
        return {.kind = Kind::sequence, .parts = {{"", &type_of<typename T::value_type>()}}};
    } else if constexpr (is_record<T>) {
        Type type{.kind = Kind::record, .name = record<T>.name};
        std::apply(
            [&]<class... Parts>(const Field<T, Parts>&... fields) {
                (type.parts.push_back({fields.name, &type_of<Parts>()}), ...);
            },
            record<T>.fields);
        return type;
    } else {
        static_assert(0 < part_count<T>);
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
    double number = 0;         ///< of a leaf
    std::vector<Value> parts;  ///< of an optional value: the value, or empty
};

[[nodiscard]] Value get_value(const Type& type, Reader& from);
void put_value(Writer& to, const Value& value);

/// The value as a T; nothing if it is of another type.
template <class T>
[[nodiscard]] std::optional<T> as(const Value& value) {
    if (value.type != &type_of<T>()) return std::nullopt;
    Writer bytes;
    put_value(bytes, value);
    Reader reader(bytes.bytes());
    return get<T>(reader);
}

/// C++ that makes the value. Answers are equal on all machines to about 14 digits.
[[nodiscard]] std::string code(const Value& value, int digits = 0);
/// Parses the output of `code` from the text's beginning, and removes it. Throws Malformed.
[[nodiscard]] Value read_value(const Type& type, std::string_view& text);

/// True if the suites would accept one for the other: within the kit's `tolerance`, or `within`.
/// NaN equals NaN, and the scale of an optional t is at least its own size.
[[nodiscard]] bool same(const Value& got, const Value& expected, double within);

/// Calls visit(number's value) for each.
template <class SomeValue, class Visit>
void for_each_number(SomeValue& value, Visit visit) {
    using Kind = Type::Kind;
    const Kind kind = value.type->kind;
    if (kind == Kind::real || kind == Kind::integer || kind == Kind::truth) visit(value);
    for (auto& part : value.parts) for_each_number(part, visit);
}

[[nodiscard]] Value without_signed_zeros(Value value);

/// The part with this name; null if there is none.
[[nodiscard]] const Value* find(const Value& value, std::string_view name);

[[nodiscard]] bool is_vec3(const Value& value);
[[nodiscard]] Vec3 vec3(const Value& value);
void set_vec3(Value& value, Vec3 v);

}  // namespace rt::contract
