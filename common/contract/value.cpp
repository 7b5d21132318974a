#include "common/contract/value.hpp"

#include "common/explain/text.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/text.hpp"

#include <cmath>

namespace rt::contract {

namespace {

using Kind = Type::Kind;

const Type& part_type(const Type& type) {
    return *type.parts.front().type;
}

std::string number_code(const Value& value, int digits) {
    if (value.type->kind == Kind::truth) return value.number != 0 ? "true" : "false";
    if (value.type->kind == Kind::integer) return std::to_string(std::int64_t(value.number));
    Real number = Real(value.number);
    if (digits > 0 && std::isfinite(number))
        number = Real(std::strtod(formatted("%.*g", digits, double(number)).c_str(), nullptr));
    return rt::code(number);
}

/// Skips characters without meaning: the name of a type or a field, "=", blanks.
void skip_names(std::string_view& text) {
    for (;;) {
        while (!text.empty() && (text.front() == ' ' || text.front() == '=')) text.remove_prefix(1);
        const std::size_t end = text.find_first_not_of(
            ".abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_:<>");
        const std::string_view word = text.substr(0, end);
        const bool is_name = word.size() > 1 && word.front() == '.' && std::isalpha(word[1]) != 0;
        const bool is_type = end != std::string_view::npos && text[end] == '{';
        if (word.empty() || (!is_name && !is_type)) return;
        text.remove_prefix(word.size());
    }
}

bool take(std::string_view& text, std::string_view expected) {
    if (!text.starts_with(expected)) return false;
    text.remove_prefix(expected.size());
    return true;
}

void need(std::string_view& text, std::string_view expected) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    if (!take(text, expected))
        throw Malformed("\"" + std::string(expected) + "\" is missing before \"" +
                        std::string(text.substr(0, 40)) + "\"");
}

double read_number(std::string_view& text) {
    if (take(text, "true")) return 1;
    if (take(text, "false")) return 0;
    if (take(text, "infinity")) return double(infinity);
    if (take(text, "-infinity")) return -double(infinity);
    if (take(text, "NAN")) return std::numeric_limits<double>::quiet_NaN();
    const bool wrapped = take(text, "Real(");
    double number = 0;
    const auto [end, error] = parse_floating(text, number);
    if (error != std::errc())
        throw Malformed("not a number: \"" + std::string(text.substr(0, 40)) + "\"");
    text.remove_prefix(std::size_t(end - text.data()));
    if (wrapped) need(text, ")");
    return number;
}

bool close_numbers(double got, double expected, double scale, double within) {
    if (std::isnan(got) || std::isnan(expected)) return std::isnan(got) && std::isnan(expected);
    if (got == expected) return true;
    if (std::isinf(got) || std::isinf(expected)) return false;
    return std::abs(got - expected) <= within * std::max(std::abs(expected), scale);
}

bool same_at(const Value& got, const Value& expected, double scale, double within) {
    switch (expected.type->kind) {
        case Kind::real:
            return close_numbers(got.number, expected.number, scale, within);
        case Kind::integer:
        case Kind::truth:
            return got.number == expected.number;
        case Kind::optional:
            scale = 0;
            break;
        case Kind::parts:
            scale = 1;
            for_each_number(expected, [&](const Value& number) {
                if (std::isfinite(number.number)) scale = std::max(scale, std::abs(number.number));
            });
            break;
        case Kind::sequence:
        case Kind::record:
            break;
    }
    if (got.parts.size() != expected.parts.size()) return false;
    for (std::size_t i = 0; i < got.parts.size(); ++i)
        if (!same_at(got.parts[i], expected.parts[i], scale, within)) return false;
    return true;
}

}  // namespace

Value get_value(const Type& type, Reader& from) {
    Value value{.type = &type};
    switch (type.kind) {
        case Kind::real:
            value.number = double(get<Real>(from));
            break;
        case Kind::truth:
            value.number = get<bool>(from) ? 1 : 0;
            break;
        case Kind::integer:
            value.number =
                type.is_signed ? double(get<std::int32_t>(from)) : double(get<std::uint32_t>(from));
            break;
        case Kind::optional:
            if (get<bool>(from)) value.parts.push_back(get_value(part_type(type), from));
            break;
        case Kind::sequence:
            for (auto count = get<std::uint32_t>(from); count > 0; --count)
                value.parts.push_back(get_value(part_type(type), from));
            break;
        case Kind::parts:
            for (int i = 0; i < type.count; ++i)
                value.parts.push_back(get_value(part_type(type), from));
            break;
        case Kind::record:
            for (const auto& [name, part] : type.parts)
                value.parts.push_back(get_value(*part, from));
            break;
    }
    return value;
}

void put_value(Writer& to, const Value& value) {
    switch (value.type->kind) {
        case Kind::real:
            put(to, Real(value.number));
            return;
        case Kind::truth:
            put(to, value.number != 0);
            return;
        case Kind::integer:
            if (value.type->is_signed)
                put(to, std::int32_t(value.number));
            else
                put(to, std::uint32_t(value.number));
            return;
        case Kind::optional:
            put(to, !value.parts.empty());
            break;
        case Kind::sequence:
            put(to, std::uint32_t(value.parts.size()));
            break;
        case Kind::parts:
        case Kind::record:
            break;
    }
    for (const Value& part : value.parts) put_value(to, part);
}

std::string code(const Value& value, int digits) {
    const Type& type = *value.type;
    if (type.kind == Kind::optional)
        return value.parts.empty() ? "std::nullopt" : code(value.parts.front(), digits);
    if (type.kind == Kind::real || type.kind == Kind::integer || type.kind == Kind::truth)
        return number_code(value, digits);
    std::string text;
    for (std::size_t i = 0; i < value.parts.size(); ++i) {
        if (i > 0) text += ", ";
        if (type.kind == Kind::record) text += std::string(".") + type.parts[i].name + " = ";
        text += code(value.parts[i], digits);
    }
    return std::string(type.name) + "{" + text + "}";
}

Value read_value(const Type& type, std::string_view& text) {
    Value value{.type = &type};
    skip_names(text);
    switch (type.kind) {
        case Kind::real:
        case Kind::truth:
        case Kind::integer:
            value.number = read_number(text);
            return value;
        case Kind::optional:
            if (!take(text, "std::nullopt"))
                value.parts.push_back(read_value(part_type(type), text));
            return value;
        case Kind::sequence:
        case Kind::parts:
        case Kind::record:
            break;
    }
    need(text, "{");
    const std::size_t count =
        type.kind == Kind::record ? type.parts.size() : std::size_t(type.count);
    for (;;) {
        skip_names(text);
        if (value.parts.empty() && take(text, "}")) break;
        const Type& part =
            type.kind == Kind::record ? *type.parts.at(value.parts.size()).type : part_type(type);
        value.parts.push_back(read_value(part, text));
        if (take(text, "}")) break;
        need(text, ",");
        if (type.kind != Kind::sequence && value.parts.size() >= count)
            throw Malformed("too many parts");
    }
    if (type.kind != Kind::sequence && value.parts.size() != count)
        throw Malformed("too few parts");
    return value;
}

bool same(const Value& got, const Value& expected, double within) {
    return same_at(got, expected, 1, within);
}

Value without_signed_zeros(Value value) {
    for_each_number(value, [](Value& number) {
        if (number.number == 0) number.number = 0;
    });
    return value;
}

const Value* find(const Value& value, std::string_view name) {
    if (value.type->kind != Kind::record) return nullptr;
    for (std::size_t i = 0; i < value.parts.size(); ++i)
        if (value.type->parts[i].name == name) return &value.parts[i];
    return nullptr;
}

bool is_vec3(const Value& value) {
    return value.type == &type_of<Vec3>();
}

Vec3 vec3(const Value& value) {
    return {Real(value.parts[0].number), Real(value.parts[1].number), Real(value.parts[2].number)};
}

void set_vec3(Value& value, Vec3 v) {
    for (glm::length_t i = 0; i < 3; ++i) value.parts[std::size_t(i)].number = double(v[i]);
}

}  // namespace rt::contract
