#include "common/course/build/static_data.hpp"

#include "common/course/build/project.hpp"
#include "common/system/files.hpp"

#include <algorithm>
#include <optional>
#include <regex>

namespace rt {

namespace {

/// "best" of "rt::trace(double)::best", and of "_ZZN2rt5traceEdE4best.0", a part of it.
std::string name_of_variable(std::string symbol) {
    static const std::regex last(R"(([A-Za-z_]\w*)(\.\d+)?$)");
    std::smatch match;
    if (!std::regex_search(symbol, match, last)) return "";
    const std::string word = match[1].str();
    if (!word.starts_with("_Z")) return word;
    for (std::size_t i = word.size(); i-- > 1;)  // a length is before each part
        if (word.substr(0, i).ends_with(std::to_string(word.size() - i))) return word.substr(i);
    return "";
}

/// The source with blanks for its comments and texts, and with the same lines.
std::string without_comments(std::string_view source) {
    static const std::regex comment(R"(//[^\n]*|/\*[^*]*\*+([^/*][^*]*\*+)*/|"([^"\\\n]|\\.)*")");
    std::string text(source);
    for (std::sregex_iterator each(text.begin(), text.end(), comment), end; each != end;) {
        const auto start = std::size_t(each->position());
        const auto length = std::size_t(each->length());
        ++each;
        for (std::size_t i = start; i < start + length; ++i)
            if (source[i] != '\n') text[i] = ' ';
    }
    return text;
}

/// The line of the source in which a variable is declared, if it is not a constant; of a pointer to
/// a constant, the pointer is none.
std::optional<int> declared_as_variable(const std::string& code, const std::string& name) {
    const std::regex word("\\b" + name + "\\b");
    std::smatch match;
    if (!std::regex_search(code, match, word)) return std::nullopt;
    const auto at = std::size_t(match.position());
    const std::size_t start = at == 0 ? 0 : code.find_last_of(";{}", at - 1) + 1;
    static const std::regex constant(R"(\bconst(expr)?\b[^*]*$)");
    if (std::regex_search(code.substr(start, at - start), constant)) return std::nullopt;
    return 1 + int(std::count(code.begin(), code.begin() + std::ptrdiff_t(at), '\n'));
}

}  // namespace

std::vector<StaticVariable> static_variables(const std::vector<Symbol>& symbols,
                                             std::string_view source) {
    std::vector<StaticVariable> variables;
    for (const Symbol& each : symbols) {
        if (std::string_view("bBdDuVC").find(each.kind) == std::string_view::npos) continue;
        if (each.name.starts_with("guard variable") || each.name.starts_with("std::")) continue;
        if (each.section.find(".rel.ro") != std::string::npos) continue;  // constant once loaded
        const std::string name = name_of_variable(each.name);
        if (name.empty()) continue;
        if (const auto declared = declared_as_variable(without_comments(source), name))
            variables.push_back({.name = name,
                                 .file = {},
                                 .line = *declared,
                                 .of_each_thread = each.section.starts_with(".t")});
    }
    const auto order = [](const StaticVariable& a, const StaticVariable& b) {
        return a.line != b.line ? a.line < b.line : a.name < b.name;
    };
    const auto same = [](const StaticVariable& a, const StaticVariable& b) {
        return a.line == b.line && a.name == b.name;
    };
    std::sort(variables.begin(), variables.end(), order);
    variables.erase(std::unique(variables.begin(), variables.end(), same), variables.end());
    return variables;
}

std::vector<StaticVariable> static_variables(int stage, const std::vector<CompiledFile>& files) {
    std::vector<StaticVariable> all;
    for (const CompiledFile& each : files) {
        if (each.stage != stage) continue;
        for (StaticVariable& found : static_variables(each.symbols, read_text(each.file))) {
            found.file = each.file.lexically_relative(project_folder);
            all.push_back(std::move(found));
        }
    }
    return all;
}

}  // namespace rt
