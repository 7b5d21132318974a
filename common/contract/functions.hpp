// The functions of a contract as a list, from which the client and the worker are generated.
#pragma once

#include "common/contract/bytes.hpp"

#include <algorithm>
#include <tuple>

namespace rt::contract {

/// A word that can be a template's argument.
template <std::size_t Size>
struct Word {
    // NOLINTNEXTLINE: a literal is converted
    constexpr Word(const char (&word)[Size]) { std::copy_n(word, Size, text); }
    char text[Size];
};

/// One function of a contract: its name, and its overload.
template <Word Name, auto Pointer>
struct Function;

template <Word Name, class Result, class... Parameters, Result (*Pointer)(Parameters...)>
struct Function<Name, Pointer> {
    using Answer = Result;
    using Arguments = std::tuple<std::decay_t<Parameters>...>;
    static constexpr const char* name = Name.text;

    /// True if the name and the arguments match.
    template <Word Called, class... Given>
    static constexpr bool is_called() {
        return std::string_view(Called.text) == Name.text &&
               std::is_same_v<Arguments, std::tuple<Given...>>;
    }

    /// The answering end: the arguments' bytes to the answer's.
    static void answer(Reader& question, Writer& answer) {
        // Braces keep the order.
        const Arguments arguments{get<std::decay_t<Parameters>>(question)...};
        question.end();
        put(answer, std::apply(Pointer, arguments));
    }
};

/// The function with this name and these arguments, among a contract's functions.
template <class Functions, Word Called, class... Given>
constexpr std::size_t find_function() {
    return []<class... Each>(std::type_identity<std::tuple<Each...>>) {
        constexpr bool matches[] = {Each::template is_called<Called, Given...>()...};
        constexpr std::size_t count = sizeof...(Each);
        constexpr std::size_t place = std::find(matches, matches + count, true) - matches;
        static_assert(place < count, "no such function in this contract");
        return place;
    }(std::type_identity<Functions>());
}

}  // namespace rt::contract
