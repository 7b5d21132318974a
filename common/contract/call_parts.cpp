#include "common/contract/call_parts.hpp"

#include <algorithm>
#include <array>

namespace rt::contract {

bool is_place(const std::string& name) {
    constexpr std::array places = {"origin", "center",   "point",    "apex",        "a",   "b",
                                   "c",      "position", "vertices", "translation", "min", "max"};
    return std::ranges::find(places, name) != places.end();
}

bool is_basis(const Value& value) {
    return value.type == &type_of<Basis>();
}

}  // namespace rt::contract
