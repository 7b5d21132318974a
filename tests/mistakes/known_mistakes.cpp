// known_mistakes PROJECT SUITE          one source of all known mistakes and other right answers
// known_mistakes PROJECT SUITE NAME     the source of one of these
//
// Writes to the standard output. In the one source, each answer is in a namespace of its own, and
// the functions of the stage call those of the answer that the environment variable RAYSTEPS_ANSWER
// names. An answer calls these functions by their names, and so itself.
#include "common/course/authoring/known_mistakes.hpp"
#include "common/system/input_error.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <set>

namespace {

namespace fs = std::filesystem;
using rt::KnownMistake, rt::RightAnswer, rt::lines_of;

/// "Vec3 normal(const Plane& plane, Vec3 point)" in parts.
struct Function {
    std::string result;
    std::string name;
    std::string parameters;
};

std::string content_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<RightAnswer> answers_of(const fs::path& project, const std::string& suite) {
    std::vector<RightAnswer> answers;
    for (const KnownMistake& mistake : rt::read_known_mistakes(project, suite))
        answers.push_back({mistake.name, {}, source_of(project, suite, mistake)});
    for (const RightAnswer& right : rt::read_right_answers(project, suite))
        answers.push_back({right.name, {}, source_of(project, suite, right)});
    return answers;
}

/// Visits the lines that begin the definition of a function in namespace rt that other files call.
template <class Visit>
void for_each_definition(std::vector<std::string>& lines, Visit visit) {
    bool is_unnamed = false;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        if (line == "namespace {") is_unnamed = true;
        if (line.starts_with("}  // namespace")) is_unnamed = false;
        const bool is_text =
            !line.empty() && std::isalpha(static_cast<unsigned char>(line[0])) != 0;
        const bool is_other = line.starts_with("static ") || line.starts_with("inline ") ||
                              line.starts_with("template") || line.starts_with("constexpr ");
        if (is_text && !is_unnamed && !is_other && line.find('(') != std::string::npos) visit(i);
    }
}

/// The functions that a file defines, from the first lines of their definitions.
std::vector<Function> functions_in(const std::string& text) {
    std::vector<Function> functions;
    std::vector<std::string> lines = lines_of(text);
    for_each_definition(lines, [&](std::size_t i) {
        std::string head = lines[i];
        while (head.find('{') == std::string::npos && i + 1 < lines.size())
            head += " " + lines[++i];
        const std::size_t open = head.find('(');
        const std::size_t name = head.find_last_of(" >&*", open) + 1;
        std::string parameters = head.substr(open + 1, head.rfind(')') - open - 1);
        for (const char* mark : {"/*", "*/"})  // of a name that is not used
            for (std::size_t at; (at = parameters.find(mark)) != std::string::npos;)
                parameters.erase(at, 2);
        functions.push_back({head.substr(0, name), head.substr(name, open - name), parameters});
    });
    return functions;
}

/// "ray, sphere, interval"
std::string arguments(const std::string& parameters) {
    std::string names;
    int depth = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i <= parameters.size(); ++i) {
        const char c = i < parameters.size() ? parameters[i] : ',';
        depth += c == '<' ? 1 : c == '>' ? -1 : 0;
        if (c != ',' || depth > 0) continue;
        const std::string parameter = parameters.substr(start, i - start);
        names += (names.empty() ? "" : ", ") + parameter.substr(parameter.find_last_of(" &*") + 1);
        start = i + 1;
    }
    return names;
}

/// The answer with other names for the definitions of these functions, so that its calls find those
/// that choose the answer.
std::string with_own_names(const std::string& text, const std::vector<Function>& functions) {
    std::vector<std::string> lines = lines_of(text);
    for_each_definition(lines, [&](std::size_t i) {
        for (const Function& function : functions) {
            const std::size_t at = lines[i].find(" " + function.name + "(");
            if (at == std::string::npos) continue;
            lines[i].insert(at + 1, "answer_");
            break;
        }
    });
    std::string whole;
    for (const std::string& line : lines) whole += line + "\n";
    return whole;
}

constexpr const char* choice = R"(
namespace rt {

namespace {

/// The place of the answer that RAYSTEPS_ANSWER names.
std::size_t chosen() {
    static const std::size_t place = [] {
        const char* const name = std::getenv("RAYSTEPS_ANSWER");
        for (std::size_t i = 0; i < std::size(names); ++i)
            if (name != nullptr && std::strcmp(name, names[i]) == 0) return i;
        std::fputs("RAYSTEPS_ANSWER names no answer of this suite\n", stderr);
        std::_Exit(2);
    }();
    return place;
}

}  // namespace
)";

void write_all(const fs::path& project, const std::string& suite) {
    const std::vector<RightAnswer> answers = answers_of(project, suite);
    const std::string stage = suite.substr(0, suite.find("_trace"));
    const std::string right = suite == stage
                                  ? "steps/" + stage + "/reference/" + stage.substr(7) + ".cpp"
                                  : "steps/" + stage + "/main.cpp";
    const std::vector<Function> functions = functions_in(content_of(project / right));
    std::cout << "#include <cstdio>\n#include <cstdlib>\n#include <cstring>\n#include <iterator>\n";
    std::set<std::string> seen;
    for (const RightAnswer& answer : answers)
        for (const std::string& line : lines_of(answer.text))
            if (line.starts_with('#') && seen.insert(line).second) std::cout << line << '\n';
    std::string names;
    for (const auto& [name, around, text] : answers) {
        std::string body;
        for (const std::string& line : lines_of(text))
            body += (line.starts_with('#') ? "" : line) + "\n";
        std::cout << "\nnamespace answer_" << name
                  << " {\nnamespace rt {\nusing namespace ::rt;\n}\n"
                  << "#line 1 \"" << suite << ": " << name << "\"\n"
                  << with_own_names(body, functions) << "}  // namespace answer_" << name << '\n';
        names += "    \"" + name + "\",\n";
    }
    std::cout << "\nstatic constexpr const char* names[] = {\n" << names << "};\n" << choice;
    for (const auto& [result, name, parameters] : functions) {
        std::cout << '\n'
                  << result << name << '(' << parameters << ") {\n    static constexpr " << result
                  << "(*answers[])(" << parameters << ") = {\n";
        for (const RightAnswer& answer : answers)
            std::cout << "        ::answer_" << answer.name << "::rt::answer_" << name << ",\n";
        std::cout << "    };\n    return answers[chosen()](" << arguments(parameters) << ");\n}\n";
    }
    std::cout << "\n}  // namespace rt\n";
}

void write_one(const fs::path& project, const std::string& suite, const std::string& name) {
    if (const auto right = rt::find_right_answer(project, suite, name)) {
        std::cout << source_of(project, suite, *right);
        return;
    }
    const auto mistakes = rt::read_known_mistakes(project, suite);
    const auto mistake = std::ranges::find(mistakes, name, &KnownMistake::name);
    if (mistake == mistakes.end())
        throw rt::InputError({}, suite + " has no known mistake or right answer " + name);
    std::cout << source_of(project, suite, *mistake);
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count == 3) return write_all(words[1], words[2]), 0;
        if (count == 4) return write_one(words[1], words[2], words[3]), 0;
        std::cerr << "known_mistakes PROJECT SUITE [NAME]\n";
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
    }
    return 2;
}
