// The pages of docs/, as lines, and the C++ in them.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace rt {

struct PageLine {
    int number = 0;  ///< from 1
    std::string text;

    /// Verbatim text in Markdown: commands, scenes, output of programs, C++.
    [[nodiscard]] bool is_verbatim() const { return text.rfind("    ", 0) == 0; }
    /// Without the blanks before it.
    [[nodiscard]] std::string words() const {
        const std::size_t first = text.find_first_not_of(' ');
        return first == std::string::npos ? "" : text.substr(first);
    }
};

inline std::vector<PageLine> read_page(const std::filesystem::path& file) {
    std::vector<PageLine> lines;
    std::ifstream stream(file);
    for (std::string line; std::getline(stream, line);)
        lines.push_back({.number = int(lines.size()) + 1, .text = line});
    return lines;
}

/// C++ that a page shows.
struct PageCode {
    enum class Kind {
        file,    ///< from its first #include on
        check,   ///< a line to paste into a test
        answer,  ///< a call of `intersect`, and its expected answer
    };
    Kind kind = Kind::file;
    int first_line = 0;
    int last_line = 0;
    std::string text = "";
    std::string expected = "";  ///< of an answer
};

inline std::vector<PageCode> code_of(const std::vector<PageLine>& page) {
    using Kind = PageCode::Kind;
    const auto open_brackets = [](const std::string& text) {
        int open = 0;
        for (const char c : text) open += (c == '(') - (c == ')');
        return open;
    };
    std::vector<PageCode> all;
    for (std::size_t i = 0; i < page.size(); ++i) {
        if (!page[i].is_verbatim()) continue;
        const std::string words = page[i].words();
        const std::size_t check = words.find("CHECK(");
        const std::size_t call = words.find("intersect(Ray{");
        PageCode code{.first_line = page[i].number};
        if (words.rfind("#include", 0) == 0) {
            for (; i < page.size() && (page[i].is_verbatim() || page[i].text.empty()); ++i)
                code.text += page[i].words() + "\n";
            --i;
        } else if (check != std::string::npos) {
            code.kind = Kind::check;
            code.text = words.substr(check);
        } else if (call != std::string::npos) {
            code.kind = Kind::answer;
            code.text = words.substr(call);
            while (open_brackets(code.text) > 0) code.text += page.at(++i).words();
            const std::string expected = "expected: ";
            std::size_t answer = i + 1;
            while (page.at(answer).words().rfind(expected, 0) != 0) ++answer;
            code.expected = page[answer].words().substr(expected.size());
        } else {
            continue;
        }
        code.last_line = page.at(i).number;
        all.push_back(code);
    }
    return all;
}

}  // namespace rt
