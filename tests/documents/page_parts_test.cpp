// All pages of stages have the same parts in the same order, and an answer for each question. Each
// work that a page cites is in the list of docs/README.md.
#include "common/stages/stages.hpp"

#include "tests/documents/page.hpp"
#include "tests/documents/page_numbers.hpp"
#include "tests/kit/picture.hpp"
#include "tests/kit/verdict.hpp"

#include <filesystem>
#include <regex>

using namespace rt;

namespace {

const std::string questions = "## Questions";
const std::string answers = "<details><summary>Answers</summary>";
const std::string curious = "<details><summary>For the curious</summary>";

std::vector<PageLine> page_of(int stage) {
    return read_page(project_file("docs/" + name_of(stage) + ".md"));
}

/// The number of the first line that begins like this, or 0.
int line_of(const std::vector<PageLine>& page, const std::string& beginning) {
    for (const PageLine& line : page)
        if (line.text.rfind(beginning, 0) == 0) return line.number;
    return 0;
}

/// The numbers of a list between two lines, in their order.
std::vector<int> list(const std::vector<PageLine>& page, int from, int to) {
    static const std::regex item(R"((\d+)\. .*)");
    std::vector<int> all;
    for (const PageLine& line : page)
        if (std::smatch match;
            line.number > from && line.number < to && std::regex_match(line.text, match, item))
            all.push_back(std::stoi(match[1]));
    return all;
}

}  // namespace

TEST_CASE("the pages of all stages have the same parts, in the same order") {
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        const std::vector<PageLine> page = page_of(stage);
        int before = 0;
        for (const std::string& part :
             {std::string("# Stage " + std::to_string(stage) + ": "),
              std::string("- **You will be able to** "), std::string("- **You need** "),
              std::string("- **It takes** "), std::string("!["), std::string("In the documents: "),
              std::string("## The idea"), std::string("## What to write"),
              std::string("<details><summary>What a graded file may include"),
              std::string("## What goes wrong"), std::string("## See it"), questions, answers,
              curious}) {
            const int line = line_of(page, part);
            CHECK(verdict(line > before, name_of(stage) + ".md: \"" + part +
                                             "\" is missing, or not at its place"));
            before = line;
        }
    }
}

TEST_CASE("each question of a page has an answer") {
    for (int stage = 1; stage <= int(stage_names.size()); ++stage) {
        const std::vector<PageLine> page = page_of(stage);
        const int middle = line_of(page, answers);
        const std::vector<int> asked = list(page, line_of(page, questions), middle);
        INFO(stage_name(stage));
        CHECK(asked.size() >= 4);
        CHECK(list(page, middle, line_of(page, curious)) == asked);
    }
}

TEST_CASE("each work that a page cites is in the list of papers") {
    // "[Ize 2013](README.md#papers)", "[Möller and Trumbore (1997)](README.md#papers)"
    static const std::regex citation(R"(\[([^\[\]]*) \(?(\d{4})\)?\]\([^)]*#papers\))");
    const std::string list = content("docs/README.md");
    int citations = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("docs"))) {
        if (entry.path().extension() != ".md") continue;
        for (const PageLine& line : read_page(entry.path())) {
            using Matches = std::sregex_iterator;
            for (Matches it(line.text.begin(), line.text.end(), citation), end; it != end; ++it) {
                const std::string work = it->str(1) + " " + it->str(2);
                CHECK(verdict(list.find("| " + work + " | ") != std::string::npos,
                              entry.path().filename().string() + " cites " + work +
                                  ", which docs/README.md does not list"));
                ++citations;
            }
        }
    }
    CHECK(citations >= 15);
}
