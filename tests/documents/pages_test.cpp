// Every number that a page prints is computed again: numbers with a decimal point, a percent or
// degree sign, or a comma between thousands, and some whole numbers. A printed number that is not
// computed fails, and so does a computed one that is not printed.

#include "tests/documents/page.hpp"
#include "tests/documents/page_numbers.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <array>
#include <fstream>
#include <regex>
#include <sstream>

using namespace rt;

namespace rt {

std::vector<Printed> numbers_in(const std::string& text, int line) {
    // Link targets, code, sections of documents, and pixels do not count.
    static const std::regex none(
        R"(\]\([^)]*\)|`[^`]*`|§(\d|\.\d|–)*|(row,column|--pixel) \d+,\d+)");
    static const std::regex each(
        R"((\d{1,3}(?:,\d{3})+|\d+)(\.\d+)?(?: \\cdot 10\^\{(-?\d+)\})?(?: ?(%|°))?)");
    const std::string plain = std::regex_replace(text, none, "_");
    std::vector<Printed> all;
    for (std::sregex_iterator it(plain.begin(), plain.end(), each), end; it != end; ++it) {
        const std::smatch& match = *it;
        const std::string digits = match.str(1);
        const bool is_whole = !match[2].matched && !match[3].matched;
        if (is_whole && !match[4].matched && digits.find(',') == std::string::npos) continue;
        std::string value = digits + match.str(2);
        value.erase(std::remove(value.begin(), value.end(), ','), value.end());
        const double power = match[3].matched ? std::stod("1e" + match.str(3)) : 1;
        const double decimals = match[2].matched ? double(match.length(2) - 1) : 0;
        all.push_back({.line = line,
                       .text = match.str(),
                       .value = std::stod(value) * power,
                       .last_digit = std::pow(10, -decimals) * power,
                       .unit = match.str(4)});
    }
    return all;
}

std::string content(const std::string& name) {
    std::ifstream stream(project_file(name));
    return {std::istreambuf_iterator<char>(stream), {}};
}

namespace {

/// A page in one line, as sentences run across lines.
std::string sentences(const std::string& page) {
    return std::regex_replace(content("docs/" + page + ".md"), std::regex(R"(\s+)"), " ");
}

}  // namespace

Verdict says(const std::string& page, const std::string& sentence) {
    return verdict(sentences(page).find(sentence) != std::string::npos,
                   "docs/" + page + ".md does not say: " + sentence);
}

std::string decimals(double value, int digits) {
    std::ostringstream out;
    out << std::fixed;
    out.precision(digits);
    out << value;
    return out.str();
}

double said_in(const std::string& file, const std::string& before, const std::string& after) {
    const std::string text = std::regex_replace(content(file), std::regex("\n *///? *"), " ");
    const std::size_t from = text.find(before);
    INFO(file << " does not say \"" << before << "… " << after << "\"");
    REQUIRE(from != std::string::npos);
    std::size_t length = 0;
    const std::string rest = text.substr(from + before.size());
    const double value = std::stod(rest, &length);
    REQUIRE(rest.compare(length, after.size(), after) == 0);
    return value;
}

}  // namespace rt

namespace {

bool is_code(const PageLine& line, const std::vector<PageCode>& codes) {
    return std::any_of(codes.begin(), codes.end(), [&line](const PageCode& code) {
        return line.number >= code.first_line && line.number <= code.last_line;
    });
}

/// A command, a scene or C++, which other parts of this suite run, or a row of stage 10's table,
/// whose rays tests/common/render/contact_test.cpp counts.
bool is_asked_elsewhere(const PageLine& line, const std::vector<PageCode>& codes) {
    static const std::regex elsewhere(
        R"(    (\./course|cmake|gdb|build/|RAYSTEPS_|L |box |mesh |Triangle\{).*)"
        R"(|\| (\$\\varepsilon|\$t > 0\.001\$ \(CR\)|`surface\.error`) .* all .*)");
    return std::regex_match(line.text, elsewhere) || is_code(line, codes);
}

std::vector<Printed> numbers_of(const std::vector<PageLine>& page) {
    const std::vector<PageCode> codes = code_of(page);
    std::vector<Printed> all;
    for (const PageLine& line : page) {
        if (is_asked_elsewhere(line, codes)) continue;
        const std::vector<Printed> more = numbers_in(line.text, line.number);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

/// True if one rounds to the other; the sign is printed before a number, not in it.
bool rounds_to(const Known& known, const Printed& printed) {
    const double value = std::abs(known.value);
    const double slack = printed.last_digit / 2 * (1 + 1e-9) + 4 * double(epsilon) * value;
    return known.unit == printed.unit && std::abs(value - printed.value) <= slack;
}

struct Page {
    std::string name;
    Knowledge (*know)();
};

Knowledge nothing() {
    return {};
}

const Page pages[] = {
    {"step01_ray_generation", stage1}, {"step02_camera_basis", stage2},  {"step03_sphere", stage3},
    {"step04_plane", stage4},          {"step05_triangle", nothing},     {"step06_square", nothing},
    {"step07_cylinder", nothing},      {"step08_cone", stage8},          {"step09_phong", stage9},
    {"step10_shadows", stage10},       {"step11_soft_shadows", stage11}, {"step12_mirror", stage12},
    {"step13_meshes", stage13},        {"debugging", debugging},
};

Verdict is_known(const Printed& printed, const Page& page, const Knowledge& all) {
    const bool known = std::any_of(all.begin(), all.end(),
                                   [&](const Known& each) { return rounds_to(each, printed); });
    return verdict(known, "docs/" + page.name + ".md:" + std::to_string(printed.line) + ": " +
                              printed.text + " is not the value computed here");
}

Verdict is_printed(const Known& known, const Page& page, const std::vector<Printed>& all) {
    const bool printed = std::any_of(all.begin(), all.end(),
                                     [&](const Printed& each) { return rounds_to(known, each); });
    return verdict(printed, "docs/" + page.name + ".md does not print " + text(Real(known.value)) +
                                known.unit + ", " + known.what);
}

}  // namespace

TEST_CASE("a page's sentences with whole numbers are true") {
    // Situation B (PHY), with the given center and with the one that its solution uses.
    const auto situation_b = [](Vec3 center) {
        const Vec3 v(0, -3, 5);
        const Vec3 r = Vec3(3, 2, 0) - center;
        return std::array{dot(v, v), 2 * dot(r, v), dot(r, r) - 9};
    };
    const auto discriminant = [](std::array<Real, 3> q) { return q[1] * q[1] - 4 * q[0] * q[2]; };
    const auto given = situation_b({1, 0, -3});
    const auto worked = situation_b({1, -3, 0});
    const auto dollars = [](Real number) { return "$" + text(number) + "$"; };
    CHECK(says("step03_sphere",
               "As given, $A = " + text(given[0]) + "$, $B = " + text(given[1]) +
                   "$, $C = " + text(given[2]) + "$ and the discriminant is " +
                   dollars(discriminant(given)) + "; as worked, $B = " + text(worked[1]) +
                   "$, $C = " + text(worked[2]) + "$ and " + dollars(discriminant(worked)) + "."));
    const Vec3 d(1, -1, 0);
    const Vec3 n(0, 2, 0);
    CHECK(says("step12_mirror", "it gives $" + text(d - 2 * dot(d, n) * n) + "$"));
    CHECK(says("step01_ray_generation", "640 / 480 is " + std::to_string(640 / 480)));
}

TEST_CASE("the table of costs in stage 5's page is the one that is counted") {
    // tests/documents/triangle_costs_test.cpp tests each row: "42 | 49 | 1 | 0".
    const std::string source = content("tests/documents/triangle_costs_test.cpp");
    const std::regex row(R"re("(\d+ \| \d+ \| \d+ \| \d+)")re");
    int rows = 0;
    for (std::sregex_iterator it(source.begin(), source.end(), row), end; it != end; ++it, ++rows)
        CHECK(says("step05_triangle", "| " + it->str(1) + " |"));
    CHECK(rows == 6);
}

TEST_CASE("every number of a page is worked out again, and is that") {
    for (const Page& page : pages) {
        const std::vector<Printed> printed =
            numbers_of(read_page(project_file("docs/" + page.name + ".md")));
        const Knowledge known = page.know();
        for (const Printed& each : printed) CHECK(is_known(each, page, known));
        for (const Known& each : known) CHECK(is_printed(each, page, printed));
    }
}

TEST_CASE("numbers are recognized and compared (this suite)") {
    const std::vector<Printed> all = numbers_in(
        "CR §2.1: [at 0.5](a1.5.md) it is `0.7`, and 1,234 of 5, 61 %, $6 \\cdot 10^{-8}$");
    REQUIRE(all.size() == 4);
    CHECK(all[0].text == "0.5");
    CHECK(rounds_to({"", 1234}, all[1]));
    CHECK(rounds_to({"", 61.4, "%"}, all[2]));
    CHECK_FALSE(rounds_to({"", 61.6, "%"}, all[2]));
    CHECK_FALSE(rounds_to({"", 61.4}, all[2]));
    CHECK(rounds_to({"", 5.96e-8}, all[3]));
    CHECK_FALSE(rounds_to({"", 5e-8}, all[3]));
}

TEST_CASE("all C++ of the pages is compiled in this suite, but that of your_own.md") {
    // The output of a compiler or a debugger has the line's number before the code.
    const std::regex code(R"(    (?! *\d+[ \t]).*[;{}])");
    const std::regex data(R"(    +(Triangle\{|Value returned|//).*)");
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("docs"))) {
        if (entry.path().extension() != ".md") continue;
        if (entry.path().filename() == "your_own.md") continue;  // tests/programs/own_test.sh
        const std::vector<PageLine> page = read_page(entry.path());
        const std::vector<PageCode> codes = code_of(page);
        for (const PageLine& line : page) {
            const bool left_out = std::regex_match(line.text, code) &&
                                  !std::regex_match(line.text, data) && !is_code(line, codes);
            CHECK(verdict(!left_out && line.text.rfind("```", 0) != 0,
                          entry.path().filename().string() + ":" + std::to_string(line.number) +
                              ": C++ that is not compiled: " + line.text));
        }
    }
}
