// Checks of options' values, with an error that quotes the value.
#pragma once

#include "common/system/escaping.hpp"

#include <CLI/CLI.hpp>

#include <charconv>
#include <string>
#include <utility>
#include <vector>

namespace rt {

/// A transform of an option's value: a whole number in the range, in decimal digits. (CLI11 alone
/// takes 010 for eight.)
inline CLI::Validator whole_number(int least, int most) {
    const auto check = [=](std::string& text) -> std::string {
        int value = 0;
        const char* const end = text.data() + text.size();
        const auto [stop, error] = std::from_chars(text.data(), end, value);
        if (error == std::errc() && stop == end && least <= value && value <= most) {
            text = std::to_string(value);
            return "";
        }
        return "expected a whole number from " + std::to_string(least) + " to " +
               std::to_string(most) + ", not " + rt::quoted(text);
    };
    return {check, ""};
}

/// A transform of an option's value: one of at least two words, each with its value of an
/// enumeration.
template <class Value>
CLI::Validator one_of(std::vector<std::pair<std::string, Value>> words) {
    const auto check = [words = std::move(words)](std::string& text) -> std::string {
        std::string list;
        for (const auto& [word, value] : words) {
            if (text == word) {
                text = std::to_string(int(value));
                return "";
            }
            list += (list.empty() ? "" : word == words.back().first ? " or " : ", ") + word;
        }
        return "expected " + list + ", not " + rt::quoted(text);
    };
    return {check, ""};
}

}  // namespace rt
