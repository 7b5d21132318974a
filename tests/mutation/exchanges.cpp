#include "tests/mutation/exchanges.hpp"

#include <algorithm>
#include <map>

namespace mutation {

bool among(std::string_view text, const Words& words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

const Words& instead_of_operator(std::string_view text) {
    static const Words none;
    static const std::map<std::string_view, Words> others = {{"+", {"-"}},
                                                             {"-", {"+"}},
                                                             {"*", {"/"}},
                                                             {"/", {"*"}},
                                                             {"%", {"*"}},
                                                             {"&&", {"||"}},
                                                             {"||", {"&&"}},
                                                             {"==", {"!="}},
                                                             {"!=", {"=="}},
                                                             {"<", {"<=", ">", ">="}},
                                                             {"<=", {"<", ">", ">="}},
                                                             {">", {">=", "<", "<="}},
                                                             {">=", {">", "<", "<="}}};
    const auto found = others.find(text);
    return found == others.end() ? none : found->second;
}

const Words& instead_of_name(std::string_view text) {
    static const Words none;
    static const std::map<std::string_view, Words> others = {
        {"min", {"max"}},    {"max", {"min"}},    {"sin", {"cos"}},       {"cos", {"sin"}},
        {"true", {"false"}}, {"false", {"true"}}, {"continue", {"break"}}};
    const auto found = others.find(text);
    return found == others.end() ? none : found->second;
}

std::vector<std::string> instead_of_number(std::string_view text) {
    if (text == "0") return {"1"};
    if (text == "1") return {"0", "2"};
    if (text == "2" || text == "3") return {text == "2" ? "1" : "2", text == "2" ? "3" : "4"};
    return {"(" + std::string(text) + " * 2)", "(" + std::string(text) + " / 2)"};
}

int binding(const Token& token) {
    if (!token.binary) return 0;
    if (among(token.text, {"*", "/", "%"})) return 6;
    if (among(token.text, {"+", "-"})) return 5;
    if (among(token.text, {"<", "<=", ">", ">="})) return 4;
    if (among(token.text, {"==", "!="})) return 3;
    if (token.text == "&&") return 2;
    return token.text == "||" ? 1 : 0;
}

bool ends_operand(const Token& token) {
    return among(token.text, {",", ";", "?", ":", "=", "+=", "-=", "*=", "/=", "return"});
}

bool opens(const Token& token) {
    return among(token.text, {"(", "[", "{"});
}

bool closes(const Token& token) {
    return among(token.text, {")", "]", "}"});
}

}  // namespace mutation
