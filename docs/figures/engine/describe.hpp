// The types of the functions' arguments and answers as JSON, from which JavaScript writes and reads
// their bytes.
#pragma once

#include "common/contract/functions.hpp"

#include <string>
#include <type_traits>
#include <vector>

namespace rt::book {

inline std::string quoted(const std::string& word) {
    return "\"" + word + "\"";
}

/// "f64", "u8", "bool", "text"; {"optional": T}, {"list": T}, {"parts": [count, T]}, or {"record":
/// [[name, T], …]}.
template <class T>
std::string json_type() {
    if constexpr (std::is_enum_v<T>) {
        return json_type<std::underlying_type_t<T>>();
    } else if constexpr (std::is_same_v<T, bool>) {
        return quoted("bool");
    } else if constexpr (std::is_same_v<T, std::vector<char>>) {
        return quoted("text");
    } else if constexpr (contract::is_number<T>) {
        const char* kind = std::is_floating_point_v<T> ? "f" : std::is_signed_v<T> ? "i" : "u";
        return quoted(kind + std::to_string(8 * sizeof(T)));
    } else if constexpr (contract::is_optional<T>) {
        return "{\"optional\":" + json_type<typename T::value_type>() + "}";
    } else if constexpr (contract::is_sequence<T>) {
        return "{\"list\":" + json_type<typename T::value_type>() + "}";
    } else if constexpr (contract::is_record<T>) {
        std::string fields;
        std::apply(
            [&](const auto&... field) {
                const auto append = [&]<class Owner, class Part>(const Field<Owner, Part>& part) {
                    fields += (fields.empty() ? "[" : ",[") + quoted(part.name) + "," +
                              json_type<Part>() + "]";
                };
                (append(field), ...);
            },
            contract::record<T>.fields);
        return "{\"record\":[" + fields + "]}";
    } else {
        using Part = std::decay_t<decltype(std::declval<T&>()[0])>;
        return "{\"parts\":[" + std::to_string(contract::part_count<T>) + "," + json_type<Part>() +
               "]}";
    }
}

/// [stage, place, name, [parameters], answer]
template <class F>
std::string json_function(int stage, int place) {
    std::string parameters;
    []<class... Each>(std::type_identity<std::tuple<Each...>>, std::string& list) {
        ((list += (list.empty() ? "" : ",") + json_type<Each>()), ...);
    }(std::type_identity<typename F::Arguments>(), parameters);
    return "[" + std::to_string(stage) + "," + std::to_string(place) + "," + quoted(F::name) +
           ",[" + parameters + "]," + json_type<typename F::Answer>() + "]";
}

}  // namespace rt::book
