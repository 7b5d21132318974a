// The parts of a call's arguments, with their names.
#pragma once

#include "common/contract/call.hpp"

#include <string>

namespace rt::contract {

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
void for_each_within(Call& call, Visit visit) {
    for (Value& argument : call.arguments) for_each_within(argument, "", visit);
}

/// True for the name of a point, false for a direction's.
[[nodiscard]] bool is_place(const std::string& name);

[[nodiscard]] bool is_basis(const Value& value);

}  // namespace rt::contract
