#include "common/course/build/compiler_errors.hpp"

#include "common/system/files.hpp"

#include <regex>

namespace rt {

namespace {

using Lines = std::vector<std::string>;

/// "…/steps/step05_triangle/student/triangle.cpp:12:5: error: …", wherever the project is.
const std::regex diagnostic(R"(([^:]+):(\d+):(\d+): (fatal error|error|warning|note): (.*))");
const std::regex students_file(R"((?:^|.*/)(steps/step\w+/student/[^:]+))");
/// A place that the compiler lists in the context of an error: "in instantiation of …".
const std::regex mention(R"((steps/step\w+/student/[^:/]+\.[a-z]+):(\d+))");
const std::regex undefined(R"(undefined (?:reference to|symbol:) [`']?(.*?)'?$)");
/// With ld and lld, the symbol comes first; with mold, two objects.
const std::regex duplicate(
    R"((?:multiple definition of|duplicate symbol:) (?:\S+\.o: \S+\.o: )?[`']?([^`';]*))");
/// A student's object, where CMake puts it.
const std::regex students_object(
    R"((steps/step\w+)/CMakeFiles/\w+_student_(?:main_)?f\d+\.dir/(student/[^:]+)\.o\b)");

/// The path of a student's file, relative to the project's folder; empty for any other file.
std::string own(const std::string& file) {
    std::smatch match;
    return std::regex_match(file, match, students_file) ? match[1].str() : "";
}

/// The source lines and carets that follow a diagnostic.
std::string shown_after(const Lines& lines, std::size_t i) {
    std::string text;
    for (++i; i < lines.size() && !lines[i].empty() && lines[i].front() == ' '; ++i)
        text += "\n" + lines[i];
    return text;
}

/// The first diagnostic of this kind in a student's file.
std::string first(const Lines& lines, const std::string& kind) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::smatch match;
        if (!std::regex_match(lines[i], match, diagnostic)) continue;
        if (match[4].str().find(kind) == std::string::npos) continue;
        const std::string file = own(match[1].str());
        if (file.empty()) continue;
        return file + ":" + match[2].str() + ":" + match[3].str() + ": " + kind + ": " +
               match[5].str() + shown_after(lines, i);
    }
    return "";
}

/// An error in a header that a line of a student's file caused.
std::string led_to(const Lines& lines) {
    std::string place;
    for (const std::string& line : lines) {
        std::smatch match;
        if (std::regex_search(line, match, mention)) place = match[1].str() + ":" + match[2].str();
        if (place.empty() || !std::regex_match(line, match, diagnostic)) continue;
        if (match[4].str().find("error") != std::string::npos)
            return place + ": error: " + match[5].str();
    }
    return "";
}

/// " in FILE and FILE", for the students' objects that the line names.
std::string objects(const std::string& line) {
    std::string text;
    for (std::sregex_iterator match(line.begin(), line.end(), students_object), end; match != end;
         ++match) {
        const std::string file = (*match)[1].str() + "/" + (*match)[2].str();
        if (text.find(file) == std::string::npos) text += (text.empty() ? " in " : " and ") + file;
    }
    return text;
}

/// Errors of the linker: missing or duplicate symbols.
std::string linker(const Lines& lines) {
    for (const std::string& line : lines) {
        std::smatch match;
        if (std::regex_search(line, match, undefined))
            return "error: nothing defines " + match[1].str() +
                   "\nIs it written, in namespace rt, with the parameters that the stage's header "
                   "has?";
        if (std::regex_search(line, match, duplicate))
            return "error: defined twice: " + match[1].str() + objects(line) +
                   (match[1].str() == "main"
                        ? "\nThe program has a main of its own: remove yours."
                        : "\nPut helper functions into an anonymous namespace: namespace { … }");
    }
    return "";
}

/// std::regex recurses along a line, and names of types can be long.
Lines short_lines(const std::string& output) {
    constexpr std::size_t longest = 2000;
    Lines lines = lines_of(output);
    for (std::string& line : lines) line.resize(std::min(line.size(), longest));
    return lines;
}

}  // namespace

std::string first_error(const std::string& output) {
    const Lines lines = short_lines(output);
    for (const std::string& found : {first(lines, "error"), led_to(lines), linker(lines)})
        if (!found.empty()) return found + "\n";
    return output;
}

std::string first_warning(const std::string& output) {
    const std::string found = first(short_lines(output), "warning");
    return found.empty() ? "" : found + "\n";
}

}  // namespace rt
