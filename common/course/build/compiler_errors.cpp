#include "common/course/build/compiler_errors.hpp"

#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <regex>

namespace rt {

namespace {

using Lines = std::vector<std::string>;

/// The patterns of the lines that compilers and linkers print.
struct Patterns {
    /// "…/steps/step05_triangle/student/triangle.cpp:12:5: error: …", wherever the project is.
    std::regex diagnostic{R"(([^:]+):(\d+):(\d+): (fatal error|error|warning|note): (.*))"};
    std::regex students_file{R"((?:^|.*/)(steps/step\w+/student/[^:]+))"};
    std::regex projects_file{R"((?:^|.*/)((?:steps|common)/[^:]+))"};
    /// A place that the compiler lists in the context of an error: "in instantiation of …".
    std::regex mention{R"((steps/step\w+/student/[^:/]+\.[a-z]+):(\d+))"};
    /// The place where g++ inlined the function of a header to which a diagnostic belongs.
    std::regex inlined{R"( +inlined from .* at (?:.*/)?(steps/step\w+/student/[^:]+:\d+:\d+).*)"};
    /// A value that is not what it seems, which explains a wrong answer; other warnings can wait.
    std::regex wrong_value{
        R"(\[-W\S*(uninitialized|dangling|local-addr|stack-address|bounds|lifetime)\S*\])"};
    std::regex undefined{R"(undefined (?:reference to|symbol:) [`']?(.*?)'?$)"};
    /// With ld, gold, lld and Apple's, the symbol comes first; with mold, two objects, which may be
    /// an archive's.
    std::regex duplicate{
        R"((?:multiple definition of|duplicate symbol:?) (?:\S+\.o\)?: \S+\.o\)?: )?[`']?([^`';]*))"};
    /// A student's object, where CMake puts it.
    std::regex students_object{
        R"((steps/step\w+)/CMakeFiles/\w+_student_(?:main_)?f\d+\.dir/(student/[^:]+)\.o\b)"};
};

/// They are compiled for the first line: an output without lines needs none.
const Patterns& patterns() {
    static const Patterns all;
    return all;
}

/// The diagnostic in line i, with the source lines and carets that follow it, and with the path
/// relative to the project's folder; empty if it is of another kind or no such file's. Sets i to
/// the line after it.
std::string diagnostic_at(std::size_t& i, const Lines& lines, const std::string& kind,
                          const std::regex& files) {
    std::smatch match;
    if (i >= lines.size() || !std::regex_match(lines[i], match, patterns().diagnostic)) return "";
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

/// The diagnostics of this kind in a student's file, each with the first note that belongs to it:
/// the header to include, or the function that was called.
Lines in_students_files(const Lines& lines, const std::string& kind) {
    Lines all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string found = diagnostic_at(i, lines, kind, patterns().students_file);
        if (found.empty()) continue;
        const std::string note = diagnostic_at(i, lines, "note", patterns().projects_file);
        all.push_back(found + (note.empty() ? "" : "\n" + note));
        --i;  // the next line may be a diagnostic
    }
    return all;
}

/// The diagnostics of this kind about a header's function that was inlined into a student's, at the
/// call, each with the student's declaration: "'t2' may be used uninitialized", of
/// interval.contains(t2).
Lines in_inlined_functions(const Lines& lines, const std::string& kind) {
    Lines all;
    std::smatch match;
    std::string call;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (std::regex_match(lines[i], match, patterns().inlined)) call = match[1].str();
        if (call.empty() || !std::regex_match(lines[i], match, patterns().diagnostic)) continue;
        if (match[4] == kind && !std::regex_match(match[1].str(), patterns().students_file)) {
            all.push_back(call + ": " + kind + ": " + match[5].str());
            while (++i < lines.size() && (lines[i].starts_with(' ') || lines[i].ends_with(':')))
                if (std::regex_match(lines[i], patterns().inlined)) break;
            const std::string note = diagnostic_at(i, lines, "note", patterns().students_file);
            if (!note.empty()) all.back() += "\n" + note;
            --i;
        }
        call.clear();
    }
    return all;
}

/// An error in a header that a line of a student's file caused.
std::string led_to(const Lines& lines) {
    std::string place;
    for (const std::string& line : lines) {
        std::smatch match;
        if (std::regex_search(line, match, patterns().mention))
            place = match[1].str() + ":" + match[2].str();
        if (place.empty() || !std::regex_match(line, match, patterns().diagnostic)) continue;
        if (match[4].str().find("error") != std::string::npos)
            return place + ": error: " + match[5].str();
    }
    return "";
}

/// "FILE, FILE", the students' objects that a linker's message names, in its first line, in one of
/// those that follow, or before it: "FILE: in function `main':".
std::string objects(const Lines& lines, std::size_t first) {
    constexpr std::size_t longest_message = 5;
    std::string text;
    const bool has_head = first > 0 && lines[first - 1].find(": in function") != std::string::npos;
    for (std::size_t i = has_head ? first - 1 : first;
         i < std::min(first + longest_message, lines.size()); ++i) {
        if (i > first && std::regex_search(lines[i], patterns().duplicate)) break;
        for (std::sregex_iterator
                 match(lines[i].begin(), lines[i].end(), patterns().students_object),
             end;
             match != end; ++match) {
            const std::string file = (*match)[1].str() + "/" + (*match)[2].str();
            if (text.find(file) == std::string::npos) text += (text.empty() ? "" : ", ") + file;
        }
    }
    return text;
}

/// Errors of the linker: missing or duplicate symbols.
std::string linker(const Lines& lines) {
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string& line = lines[i];
        std::smatch match;
        if (std::regex_search(line, match, patterns().undefined))
            return tr("error: nothing defines {symbol}", {{"symbol", match[1].str()}}) + "\n" +
                   tr("Is it written, in namespace rt, with the parameters that the stage's header "
                      "has?");
        if (!std::regex_search(line, match, patterns().duplicate)) continue;
        const std::string symbol = match[1] == "_main" ? "main" : match[1].str();  // Apple's
        const std::string files = objects(lines, i);
        const Values values = {{"symbol", symbol}, {"files", files}};
        return (files.empty() ? tr("error: defined twice: {symbol}", values)
                              : tr("error: defined twice: {symbol} in {files}", values)) +
               "\n" +
               (symbol == "main"
                    ? tr("The program has a main of its own: remove yours.")
                    : tr("Put helper functions into an anonymous namespace: namespace { … }"));
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
    for (const Lines& errors :
         {in_students_files(lines, "error"), in_inlined_functions(lines, "error")})
        if (!errors.empty()) return errors.front() + "\n";
    for (const std::string& found : {led_to(lines), linker(lines)})
        if (!found.empty()) return found + "\n";
    return output;
}

std::string first_warning(const std::string& output) {
    const Lines lines = short_lines(output);
    Lines all = in_students_files(lines, "warning");
    const Lines of_headers = in_inlined_functions(lines, "warning");
    all.insert(all.end(), of_headers.begin(), of_headers.end());
    if (all.empty()) return "";
    const auto telling = std::ranges::find_if(all, [](const std::string& warning) {
        return std::regex_search(warning, patterns().wrong_value);
    });
    return (telling == all.end() ? all.front() : *telling) + "\n";
}

}  // namespace rt
