#include "tests/mutation/mutants.hpp"

#include "common/system/files.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

namespace mutation {

namespace {

class Maker {
public:
    explicit Maker(std::string_view source) : source_(source), tokens_(tokens_of(source)) {}

    std::vector<Mutant> made() {
        for (int i = 0; i < size(); ++i) {
            if (text(i) == "(") {
                function_ = text(i - 1);
                i = tokens_[i].partner;  // the parameters
                if (text(i + 1) != "{") continue;
                mutate(i + 2, tokens_[i + 1].partner);
                i = tokens_[i + 1].partner;
            } else if (text(i) == "=") {  // of a constant at namespace scope
                function_ = text(i - 1);
                const int first = i + 1;
                while (text(i) != ";") ++i;
                mutate(first, i);
            }
        }
        return std::move(mutants_);
    }

private:
    [[nodiscard]] int size() const { return int(tokens_.size()); }
    [[nodiscard]] std::string_view text(int i) const {
        return i < size() ? tokens_[i].text : std::string_view();
    }
    [[nodiscard]] std::size_t start(int i) const {
        return std::size_t(tokens_[i].text.data() - source_.data());
    }
    [[nodiscard]] std::size_t end(int i) const { return start(i) + tokens_[i].text.size(); }
    /// The source of the tokens from first to last.
    [[nodiscard]] std::string code(int first, int last) const {
        return std::string(source_.substr(start(first), end(last) - start(first)));
    }

    void mutate(int first, int last) {
        for (int i = first; i < last; ++i) {
            if (tokens_[i].binary) change_operator(i);
            if (text(i) == "?") change_condition(left_operand(i, 1), i - 1);
            if (text(i) == "if") change_condition(i + 2, tokens_[i + 1].partner - 1);
            if (!tokens_[i].binary && (text(i) == "-" || text(i) == "!")) put(i, i, "");
            const bool of_type = text(i + 1) == ">" && !tokens_[i + 1].binary;
            if (is_number(tokens_[i]) && !of_type)
                for (const std::string& other : instead_of_number(text(i))) put(i, i, other);
            if (is_name(tokens_[i]) && !designates(i)) change_name(i);
            if (is_name(tokens_[i]) && text(i + 1) == "(") change_call(i);
            if (among(text(i - 1), {";", "{", "}"})) leave_out_assignment(i);
        }
    }

    void change_operator(int i) {
        for (const std::string_view other : instead_of_operator(text(i)))
            put(i, i, std::string(other));
        if (!among(text(i), {"+", "-", "*", "/", "%", "&&", "||"})) return;
        const int first = left_operand(i, binding(tokens_[i]));
        const int last = right_operand(i, binding(tokens_[i]));
        put(first, last, code(first, i - 1));
        if (text(i) == "-") put(first, last, "-" + code(i + 1, last));
        if (text(i) == "+" || text(i) == "-") put(first, i - 1, "-(" + code(first, i - 1) + ")");
        if (among(text(i), {"+", "*", "&&", "||"})) put(first, last, code(i + 1, last));
    }

    void change_condition(int first, int last) {
        put(first, last, "true");
        put(first, last, "false");
    }

    void change_name(int i) {
        for (const std::string_view other : instead_of_name(text(i))) put(i, i, std::string(other));
        static const Words components = {"x", "y", "z"};
        if (text(i - 1) != "." || !among(text(i), components)) return;
        for (const std::string_view other : components)
            if (other != text(i)) put(i, i, std::string(other));
    }

    /// Exchanges its arguments, or replaces the call by an argument.
    void change_call(int i) {
        const bool of_type = std::isupper(static_cast<unsigned char>(text(i)[0])) != 0;
        const bool declares = is_name(tokens_[i - 1]) && text(i - 1) != "return";
        if (of_type || declares || text(i - 1) == "." ||
            among(text(i), {"if", "for", "while", "return"}))
            return;
        const int close = tokens_[i + 1].partner;
        const int first = text(i - 1) == "::" ? i - 2 : i;
        std::vector<std::string> arguments;
        for (int from = i + 2; from < close;) {
            const int last = argument_end(from, close);
            arguments.push_back(code(from, last));
            from = last + 2;
        }
        if (arguments.size() > 2) return;
        for (const std::string& argument : arguments) put(first, close, "(" + argument + ")");
        if (arguments.size() == 2 && !among(text(i), {"dot", "min", "max", "swap"}))
            put(i + 2, close - 1, arguments[1] + ", " + arguments[0]);
    }

    void leave_out_assignment(int i) {
        if (!is_name(tokens_[i]) || !among(text(i + 1), {".", "->", "[", "="})) return;
        int last = i;
        while (text(last) != ";") ++last;
        put(i, last, ";");
    }

    /// True for a name in a designator, {.name = …}.
    [[nodiscard]] bool designates(int i) const {
        return text(i - 1) == "." && text(i + 1) == "=" &&
               (opens(tokens_[i - 2]) || text(i - 2) == ",");
    }

    [[nodiscard]] int argument_end(int from, int close) const {
        int i = from;
        while (i < close && text(i) != ",") i = opens(tokens_[i]) ? tokens_[i].partner + 1 : i + 1;
        return i - 1;
    }

    /// The start of the operand before an operator, with everything that binds as strongly or more.
    [[nodiscard]] int left_operand(int i, int bound) const {
        int first = i;
        while (true) {
            const Token& token = tokens_[first - 1];
            const int binds = binding(token);
            if (opens(token) || ends_operand(token) || (binds > 0 && binds < bound)) return first;
            first = closes(token) ? token.partner : first - 1;
        }
    }

    /// The end of the operand after an operator, with everything that binds more strongly.
    [[nodiscard]] int right_operand(int i, int bound) const {
        int last = i;
        while (true) {
            const Token& token = tokens_[last + 1];
            const int binds = binding(token);
            if (closes(token) || ends_operand(token) || (binds > 0 && binds <= bound)) return last;
            last = opens(token) ? token.partner : last + 1;
        }
    }

    /// A mutant with other text for the tokens from first to last.
    void put(int first, int last, const std::string& other) {
        const std::size_t from = start(first);
        const std::size_t to = end(last);
        Mutant mutant;
        mutant.source = source_;
        mutant.source.replace(from, to - from, other);
        if (!seen_.insert(mutant.source).second) return;
        mutant.line = 1 + int(std::count(source_.begin(), source_.begin() + from, '\n'));
        mutant.function = function_;
        mutant.before = lines(source_, from, to);
        mutant.after = lines(mutant.source, from, from + other.size());
        mutants_.push_back(mutant);
    }

    /// The lines that have these characters, without their comments.
    static std::string lines(std::string_view source, std::size_t from, std::size_t to) {
        from = source.rfind('\n', from) + 1;
        to = source.find('\n', to);
        std::istringstream rest{std::string(source.substr(from, to - from))};
        std::string joined;
        for (std::string line; std::getline(rest, line);) {
            std::istringstream words(line.substr(0, line.find("//")));
            for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
        }
        return joined;
    }

    std::string_view source_;
    std::vector<Token> tokens_;
    std::string function_;
    std::vector<Mutant> mutants_;
    std::set<std::string> seen_;
};

}  // namespace

std::vector<Mutant> mutants_of(std::string_view source) {
    return Maker(source).made();
}

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

namespace {

bool in_word(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool in_number(char c) {
    return in_word(c) || c == '.' || c == '\'';
}

bool is_space(char c) {
    return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The length of a non-code prefix: a space, a comment, a preprocessor line.
std::size_t skipped(std::string_view rest) {
    if (is_space(rest[0])) return 1;
    if (rest[0] == '#' || rest.starts_with("//")) return std::min(rest.find('\n'), rest.size());
    if (rest.starts_with("/*")) return rest.find("*/") + 2;
    return 0;
}

std::size_t quoted(std::string_view rest) {
    std::size_t end = 1;
    while (rest[end] != rest[0]) end += rest[end] == '\\' ? 2 : 1;
    return end + 1;
}

std::size_t length_of_token(std::string_view rest) {
    if (rest[0] == '"' || rest[0] == '\'') return quoted(rest);
    if (in_word(rest[0])) {
        const auto part = std::isdigit(static_cast<unsigned char>(rest[0])) ? in_number : in_word;
        return std::size_t(std::find_if_not(rest.begin(), rest.end(), part) - rest.begin());
    }
    constexpr std::array<std::string_view, 14> two = {"::", "->", "<=", ">=", "==", "!=", "&&",
                                                      "||", "++", "--", "+=", "-=", "*=", "/="};
    const auto starts = [rest](std::string_view symbol) { return rest.starts_with(symbol); };
    return std::any_of(two.begin(), two.end(), starts) ? 2 : 1;
}

void pair_brackets(std::vector<Token>& tokens) {
    std::vector<int> open;
    for (int i = 0; i < int(tokens.size()); ++i) {
        const std::string_view text = tokens[i].text;
        if (text == "(" || text == "[" || text == "{") open.push_back(i);
        if (text != ")" && text != "]" && text != "}") continue;
        tokens[i].partner = open.back();
        tokens[open.back()].partner = i;
        open.pop_back();
    }
}

}  // namespace

std::vector<Token> tokens_of(std::string_view source) {
    std::vector<Token> tokens;
    for (std::size_t at = 0; at < source.size();) {
        const std::string_view rest = source.substr(at);
        if (const std::size_t none = skipped(rest); none > 0) {
            at += none;
            continue;
        }
        const std::size_t length = length_of_token(rest);
        const bool apart = is_space(source[at - 1]) && is_space(source[at + length]);
        tokens.push_back({.text = rest.substr(0, length), .binary = apart});
        at += length;
    }
    pair_brackets(tokens);
    return tokens;
}

bool is_name(const Token& token) {
    return in_word(token.text[0]) && !is_number(token);
}

bool is_number(const Token& token) {
    return std::isdigit(static_cast<unsigned char>(token.text[0])) != 0;
}

namespace {

/// The texts before and after the first occurrence of a mark.
std::pair<std::string, std::string> parted(const std::string& line, const std::string& mark) {
    const std::size_t at = line.find(mark);
    if (at == std::string::npos) return {line, ""};
    return {line.substr(0, at), line.substr(at + mark.size())};
}

}  // namespace

std::vector<Survivor> read_survivors(const std::filesystem::path& file) {
    std::istringstream lines(rt::read_text(file));
    std::vector<Survivor> survivors;
    Survivor next;
    std::size_t without_reason = 0;  // the first one
    for (std::string line; std::getline(lines, line);) {
        if (line.empty() || line.starts_with("#")) continue;
        if (line.starts_with("- ")) {
            next.before = line.substr(2);
        } else if (line.starts_with("+ ")) {
            next.after = line.substr(2);
            survivors.push_back(next);
        } else if (line.starts_with("step")) {
            std::tie(next.stage, next.function) = parted(line, " ");
        } else if (line.starts_with("equivalent: ") || line.starts_with("accuracy: ")) {
            for (; without_reason < survivors.size(); ++without_reason)
                std::tie(survivors[without_reason].kind, survivors[without_reason].reason) =
                    parted(line, ": ");
        } else {
            throw std::runtime_error(file.string() + ": what is this? " + line);
        }
    }
    if (without_reason < survivors.size())
        throw std::runtime_error(file.string() + ": no reason for " + next.after);
    return survivors;
}

const Survivor* find(const std::vector<Survivor>& survivors, const std::string& stage,
                     const Mutant& mutant) {
    const auto found = std::find_if(survivors.begin(), survivors.end(), [&](const Survivor& one) {
        return one.stage == stage && one.function == mutant.function &&
               one.before == mutant.before && one.after == mutant.after;
    });
    return found == survivors.end() ? nullptr : &*found;
}

}  // namespace mutation
