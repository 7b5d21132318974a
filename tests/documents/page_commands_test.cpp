// Commands and scenes in the README and the pages are such that the programs take them.
#include "common/program/options.hpp"
#include "common/scene_file/reader.hpp"
#include "common/stages/stages.hpp"
#include "common/system/input_error.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/documents/page.hpp"
#include "tests/kit/picture.hpp"

#include <algorithm>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>

using namespace rt;

namespace {

/// A command, or a line of a scene, and its place.
struct Shown {
    std::string place;
    std::string text;
};

/// All matches of the pattern's group in the README and in the pages.
std::vector<Shown> shown(const std::regex& pattern) {
    std::vector<std::filesystem::path> files = {project_file("README.md")};
    for (const auto& entry : std::filesystem::recursive_directory_iterator(project_file("docs")))
        if (entry.path().extension() == ".md") files.push_back(entry.path());
    std::vector<Shown> all;
    for (const auto& file : files)
        for (const PageLine& line : read_page(file)) {
            using Matches = std::sregex_iterator;
            for (Matches it(line.text.begin(), line.text.end(), pattern), end; it != end; ++it)
                all.push_back(
                    {file.filename().string() + ":" + std::to_string(line.number), it->str(1)});
        }
    return all;
}

/// The commands that `./course` lists: `add("test [N] …", …)` in its sources.
std::set<std::string> commands() {
    static const std::regex command(R"(add(?:_of_stage|_of_program)?\( *"([a-z]+))");
    std::string source;
    for (const char* file :
         {"common/course/student_commands.cpp", "common/course/author_commands.cpp"})
        for (const PageLine& line : read_page(project_file(file))) source += line.words();
    std::set<std::string> all;
    using Matches = std::sregex_iterator;
    for (Matches it(source.begin(), source.end(), command), end; it != end; ++it)
        all.insert(it->str(1));
    return all;
}

/// Empty, or the error in the words after `./course`.
std::string complaint(std::vector<std::string> words) {
    static const std::set<std::string> known = commands();
    static const std::set<std::string> draw = {"run", "compare", "explain"};
    static const std::set<std::string> no_stage = {"book",    "grade", "handout",
                                                   "measure", "own",   "update"};
    if (words.size() > 1 && words[0] == "--lang") words.erase(words.begin(), words.begin() + 2);
    if (words.empty() || words[0] == "--help" || words[0] == "--version") return "";
    const std::string command = words[0];
    words.erase(words.begin());
    if (known.count(command) == 0) return "there is no such command";
    if (no_stage.count(command) > 0) return "";
    int stage = mesh_stage;
    if (!words.empty() && words[0][0] != '-') {
        const std::optional<int> found = find_stage(words[0]);
        if (!found) return "there is no such stage";
        stage = *found;
        words.erase(words.begin());
    }
    if (command == "test") return "";   // the rest is ctest's
    if (command == "debug") return "";  // the rest is a case's name
    if (command == "check")
        std::erase_if(words, [](auto& word) { return word == "--all" || word == "--sanitize"; });
    if (draw.count(command) == 0) return words.empty() ? "" : "it does not take this argument";
    std::vector<const char*> arguments = {"program"};
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (words[i] == "--mine") continue;
        if (words[i] == "--reference")
            ++i;
        else
            arguments.push_back(words[i].c_str());
    }
    try {
        // A separate program, which `run` selects.
        const bool exact = std::find(words.begin(), words.end(), "exact") != words.end();
        (void)parse_options({.stage = stage, .root = RAYSTEPS_ROOT, .exact = exact},
                            int(arguments.size()), arguments.data());
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("every command in the pages is one that ./course takes") {
    // At the start of a line, up to a remark; or in backticks.
    static const std::regex command(R"((?:^    |`)\./course((?: [^ `#]+)*))");
    const std::vector<Shown> all = shown(command);
    CHECK(all.size() > 50);
    for (const auto& [place, text] : all) {
        std::istringstream stream(text);
        const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
        const std::string wrong = complaint(words);
        CHECK(verdict(wrong.empty(), place + ": ./course" + text + ": " + wrong));
    }
}

TEST_CASE("a command that is not there is noticed (this suite)") {
    CHECK_FALSE(complaint({"draw", "5"}).empty());
    CHECK_FALSE(complaint({"check", "14"}).empty());
    CHECK_FALSE(complaint({"check", "5", "--mine"}).empty());
    CHECK_FALSE(complaint({"run", "5", "--depth", "2"}).empty());
    CHECK_FALSE(complaint({"run", "12", "--depth", "deep"}).empty());
    CHECK(complaint({"run", "12", "--depth", "2", "--mine", "--reference", "3"}).empty());
}

TEST_CASE("every line of a scene in the stages' pages is read, to the letter") {
    static const std::regex element(R"(^    ((?:R|A|C|L|sky|sp|pl|tr|sq|cy|co|box|mesh) .*))");
    const std::vector<Shown> all = shown(element);
    CHECK(all.size() >= 3);
    for (const auto& [place, line] : all) {
        if (place.rfind("step", 0) != 0) continue;
        INFO(place << ": " << line);
        CHECK_NOTHROW(parse_scene("C 0,0,0 0,0,-1 60\n" + line + "\n", place, orthonormal_basis,
                                  {.strict = true}));
    }
}
