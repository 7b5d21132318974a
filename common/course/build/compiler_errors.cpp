#include "common/course/build/compiler_errors.hpp"

#include "common/system/files.hpp"

#include <regex>

namespace rt {

namespace {

using Lines = std::vector<std::string>;

/// "…/steps/step05_triangle/student/triangle.cpp:12:5: error: …", wherever the project is.
const std::regex diagnostic(R"(([^:]+):(\d+):(\d+): (fatal error|error|warning|note): (.*))");
const std::regex students_file(R"((?:^|.*/)(steps/step\w+/student/[^:]+))");
const std::regex projects_file(R"((?:^|.*/)((?:steps|common)/[^:]+))");
/// A place that the compiler lists in the context of an error: "in instantiation of …".
const std::regex mention(R"((steps/step\w+/student/[^:/]+\.[a-z]+):(\d+))");
const std::regex undefined(R"(undefined (?:reference to|symbol:) [`']?(.*?)'?$)");
/// With ld and lld, the symbol comes first; with mold, two objects.
const std::regex duplicate(
    R"((?:multiple definition of|duplicate symbol:) (?:\S+\.o: \S+\.o: )?[`']?([^`';]*))");
/// A student's object, where CMake puts it.
const std::regex students_object(
    R"((steps/step\w+)/CMakeFiles/\w+_student_(?:main_)?f\d+\.dir/(student/[^:]+)\.o\b)");

/// The diagnostic in line i, with the source lines and carets that follow it, and with the path
/// relative to the project's folder; empty if it is of another kind or no such file's. Sets i to
/// the line after it.
std::string diagnostic_at(std::size_t& i, const Lines& lines, const std::string& kind,
                          const std::regex& files) {
    std::smatch match;
    if (i >= lines.size() || !std::regex_match(lines[i], match, diagnostic)) return "";
    if (match[4].str().find(kind) == std::string::npos) return "";
    const std::string file = match[1].str();
    std::smatch path;
    if (!std::regex_match(file, path, files)) return "";
    std::string text = path[1].str() + ":" + match[2].str() + ":" + match[3].str() + ": " + kind +
                       ": " + match[5].str();
    for (++i; i < lines.size() && !lines[i].empty() && lines[i].front() == ' '; ++i)
        text += "\n" + lines[i];
    return text;
}

/// The first diagnostic of this kind in a student's file, with the first note that belongs to it:
/// the header to include, or the function that was called.
std::string first(const Lines& lines, const std::string& kind) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string found = diagnostic_at(i, lines, kind, students_file);
        if (found.empty()) continue;
        const std::string note = diagnostic_at(i, lines, "note", projects_file);
        return found + (note.empty() ? "" : "\n" + note);
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
