// The formulas of the README and the pages are displayed correctly on GitHub. GitHub applies
// Markdown's backslash escapes inside a formula before it typesets it, ends a formula at the line's
// end, and does not always recognize a formula that ends bold or italic text. A formula beside a
// letter or a digit is no formula, a bar in it ends the cell of a table, and "<" before a letter
// begins a tag. Markdown in folded text begins after an empty line.
#include "tests/documents/page.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/verdict.hpp"

#include <algorithm>
#include <regex>

using namespace rt;

namespace {

/// The lines that GitHub would display wrongly: "LINE: reason", or nothing.
std::vector<std::string> faults(const std::vector<PageLine>& page) {
    static const std::regex code(R"(`[^`]*`)");
    static const std::regex formula(R"(\$[^$]*\$)");
    static const std::regex escape(R"(\\[!-/:-@\[-`{-~])");
    static const std::regex ends_emphasis(R"(\$[*_])");
    static const std::regex touches_a_word("[A-Za-z0-9]\x01|\\$[A-Za-z0-9]");
    static const std::regex tag("<[A-Za-z/!]");
    std::vector<std::string> all;
    bool displayed = false;  // between $$ and $$
    bool folded = false;     // after a summary
    for (const PageLine& line : page) {
        if (folded && !line.text.empty())
            all.push_back(std::to_string(line.number) + ": no empty line after a summary");
        folded = line.text.find("</summary>") != std::string::npos;
        if (line.is_verbatim()) continue;
        const auto found = [&](const std::string& why) {
            all.push_back(std::to_string(line.number) + ": " + why + ": " + line.text);
        };
        const std::string text = std::regex_replace(line.text, code, "code");
        const std::string mark = "$$";
        bool is_inline = !displayed;
        for (std::size_t at = text.find(mark); at != std::string::npos;
             at = text.find(mark, at + mark.size())) {
            displayed = !displayed;
            is_inline = false;
        }
        if (!is_inline) {
            if (std::regex_search(text, escape)) found("a backslash before punctuation");
            if (std::regex_search(text, tag)) found("a tag in a formula");
            continue;
        }
        if (std::count(text.begin(), text.end(), '$') % 2 != 0) {
            found("a formula across a line's end");
            continue;
        }
        // With each formula as $x$, what follows a dollar is outside of formulas.
        std::string formulas;
        for (std::sregex_iterator it(text.begin(), text.end(), formula), end; it != end; ++it)
            formulas += it->str();
        if (std::regex_search(formulas, escape)) found("a backslash before punctuation");
        if (std::regex_search(formulas, tag)) found("a tag in a formula");
        if (text.rfind('|', 0) == 0 && formulas.find('|') != std::string::npos)
            found("a bar in a formula of a table");
        const std::string outside = std::regex_replace(text, formula, "\x01$$");
        if (std::regex_search(outside, ends_emphasis)) found("a formula at the end of bold text");
        if (std::regex_search(outside, touches_a_word)) found("a formula beside a letter");
    }
    return all;
}

std::vector<PageLine> lines(const std::vector<std::string>& texts) {
    std::vector<PageLine> page;
    for (const std::string& text : texts) page.push_back({int(page.size()) + 1, text});
    return page;
}

}  // namespace

TEST_CASE("GitHub shows every formula of the pages as it is written") {
    std::vector<std::filesystem::path> files = {project_file("README.md")};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("docs")))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    CHECK(files.size() > 20);
    for (const auto& file : files)
        for (const std::string& fault : faults(read_page(file)))
            CHECK(verdict(false, file.filename().string() + ":" + fault));
}

TEST_CASE("a formula that GitHub would spoil is noticed (this suite)") {
    CHECK(faults(lines({R"(a formula $t\,d$)"})).size() == 1);
    CHECK(faults(lines({R"($$a\;b$$)"})).size() == 1);
    CHECK(faults(lines({"$$", R"(\lbrace a\})", "$$"})).size() == 1);
    CHECK(faults(lines({"where $t", "d$ is"})).size() == 2);
    CHECK(faults(lines({"**the factor $2$** is lost"})).size() == 1);
    CHECK(faults(lines({"the $n$th ray"})).size() == 1);
    CHECK(faults(lines({"of 2$n$ rays"})).size() == 1);
    CHECK(faults(lines({"| $|x|$ | a cell |"})).size() == 1);
    CHECK(faults(lines({"if $a<b$"})).size() == 1);
    CHECK(faults(lines({"$$", "a<b", "$$"})).size() == 1);
    CHECK(faults(lines({"<details><summary>Answers</summary>", "1. One."})).size() == 1);
    CHECK(
        faults(lines({"<details><summary>Answers</summary>", "", "$a < b$, $|x|$-axis"})).empty());
    CHECK(faults(lines({"**$2$ is lost**, *$t$ too*, `$t\\,d$`, $a$ and $b_1$"})).empty());
    CHECK(faults(lines({"    echo $HOME \\, $1"})).empty());
}
