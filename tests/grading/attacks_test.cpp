// Hostile submissions in a graded run: none gets more cases than it honestly earns, and none does
// any harm. The texts in attacks/ contain them by theme, each with its limit:
//
//   attack quick_exits: exits by quick_exit, past all destructors
//   ceiling: as a stub             or the number of cases with right answers
//   stage: step05_triangle         default: step03_sphere
//   file: main.cpp                 default: the file of the stage's functions
//   compiles: no                   or: perhaps
//   message: defines main          the student's message contains it
//   message without: root:         the message does not contain it
//   processor: 25                  its grading takes at most these seconds of processor time
//
// After a blank line, its source follows. In it, @ROOT@ is the project's folder and @RESULTS@ a
// file of results, which an attacker may know, and @normal@ the source of that name in
// attacks/parts.txt.
#include "common/course/authoring/known_mistakes.hpp"
#include "common/course/build/suite_report.hpp"
#include "common/course/grade/judging/workshop.hpp"
#include "common/course/grade/sandbox/seal.hpp"
#include "common/stages/stages.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

using namespace rt;
using namespace std::string_literals;
namespace fs = std::filesystem;

namespace {

constexpr std::chrono::seconds longest_grading{60};

std::string replaced(std::string text, const std::string& word, const std::string& by) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at))
        text.replace(at, word.size(), by);
    return text;
}

/// The processor time of all processes that have ended, in seconds.
double processor_time() {
    rusage used{};
    getrusage(RUSAGE_CHILDREN, &used);
    return double(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
           double(used.ru_utime.tv_usec + used.ru_stime.tv_usec) * 1e-6;
}

struct Attack {
    std::string name;
    std::map<std::string, std::string> head;
    std::string text;

    /// The text after "<word>: " in the head.
    [[nodiscard]] std::string said(const std::string& word, const std::string& otherwise) const {
        const auto found = head.find(word);
        return found == head.end() ? otherwise : found->second;
    }
    [[nodiscard]] std::string stage() const { return said("stage", "step03_sphere"); }
    [[nodiscard]] GradedFile file() const {
        return {*find_stage(stage()), said("file", "") == "main.cpp"};
    }
};

/// The sections of a text, "attack NAME: …" or "part NAME", in its order.
std::vector<Attack> sections_of(const fs::path& file, const std::string& kind) {
    std::vector<Attack> sections;
    bool is_head = false;
    for (const std::string& line : lines_of(read_text(file))) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with(kind + " ")) {
            const std::size_t start = kind.size() + 1;
            sections.push_back({.name = line.substr(start, colon - start), .head = {}, .text = ""});
            is_head = true;
        } else if (line.empty() && is_head) {
            is_head = false;
        } else if (is_head) {
            sections.back().head[line.substr(0, colon)] = line.substr(colon + 2);
        } else if (!sections.empty()) {
            sections.back().text += line + "\n";
        }
    }
    return sections;
}

/// All attacks, by name.
std::vector<Attack> all_attacks() {
    std::vector<Attack> attacks;
    const std::vector<Attack> parts = sections_of(RAYSTEPS_ATTACKS "/parts.txt", "part");
    for (const fs::path& file : files_in(RAYSTEPS_ATTACKS, ".txt"))
        for (Attack& attack : sections_of(file, "attack")) {
            for (const Attack& part : parts)
                attack.text = replaced(attack.text, "@" + part.name + "@", part.text);
            attacks.push_back(std::move(attack));
        }
    std::ranges::sort(attacks, {}, &Attack::name);
    return attacks;
}

/// The result of a submission.
struct Grade {
    std::set<std::string> passed;
    std::string message;
    bool compiled = false;
    std::chrono::duration<double> time{};
    double processor_time = 0;
};

std::set<std::string> passed_cases(const std::string& report) {
    std::set<std::string> passed;
    for (const CaseResult& each : read_report(report))
        if (each.passed) passed.insert(each.name);
    return passed;
}

/// A class folder as in a real run: with other students' results in it.
class Grader {
public:
    Grader() {
        fs::permissions(folder_, fs::perms(0755));
        workshop_ = grade::open_workshop(RAYSTEPS_ROOT, RAYSTEPS_BUILD, folder_);
        std::ofstream(results()) << treasure;
        fs::permissions(results(), fs::perms(0666));  // only the seal keeps it
        setenv("RAYSTEPS_SEALED", workshop_.sealed.c_str(), 1);
        setenv("RAYSTEPS_WORKER", worker().c_str(), 1);
        setenv("RAYSTEPS_REPORT", report().c_str(), 1);
        setenv("RAYSTEPS_SECONDS", "0.5", 1);
        setenv("RAYSTEPS_CASE_SECONDS", "1", 1);
        setenv("RAYSTEPS_SUITE_SECONDS", "2.5", 1);
    }

    Grade grade(const Attack& attack) {
        const auto start = std::chrono::steady_clock::now();
        const GradedFile file = attack.file();
        const double used = processor_time();
        const std::string text =
            replaced(replaced(attack.text, "@ROOT@", RAYSTEPS_ROOT), "@RESULTS@", results());
        fs::remove(worker());
        fs::remove(report());
        Grade grade;
        grade::Build made = grade::compile_submission(workshop_, file, text, object());
        if (made.succeeded)
            made = grade::link_worker(workshop_, file.stage, {{file, object()}}, worker());
        grade.compiled = made.succeeded;
        grade.message = made.words;
        if (made.succeeded) {
            const std::string limits = grade::worker_limits(file.stage) + " cpu=1";
            setenv("RAYSTEPS_LIMITS", limits.c_str(), 1);
            const std::string suite =
                std::string(RAYSTEPS_BUILD) + "/" + name_of(file) + "_asked_test_double";
            const auto limit =
                std::chrono::ceil<std::chrono::seconds>(longest_grading * grade::busy());
            const ProcessResult ending = run_captured({suite}, limit);
            CHECK_FALSE(ending.out_of_time);
            CHECK(ending.crash.empty());  // the suite itself came to its end
            grade.passed = passed_cases(read_text(report()));
            grade.message += read_text(report());
        }
        grade.time = std::chrono::steady_clock::now() - start;
        grade.processor_time = processor_time() - used;
        return grade;
    }

    /// Nothing of the grader's is changed or left over.
    [[nodiscard]] bool is_unharmed() const {
        std::set<std::string> here;
        for (const auto& each : fs::directory_iterator(folder_))
            here.insert(each.path().filename());
        const std::set<std::string> expected{"headers",      "seats",  "unpack",    "results.jsonl",
                                             "submission.o", "worker", "report.txt"};
        return read_text(results()) == treasure &&
               std::includes(expected.begin(), expected.end(), here.begin(), here.end());
    }

    [[nodiscard]] int workers_left() const {
        int count = 0;
        for (const auto& each : fs::directory_iterator("/proc")) {
            std::error_code none;
            const fs::path program = fs::read_symlink(each.path() / "exe", none);
            count += program.string().rfind(folder_.string(), 0) == 0;
        }
        return count;
    }

private:
    [[nodiscard]] fs::path object() const { return folder_ / "submission.o"; }
    [[nodiscard]] fs::path worker() const { return folder_ / "worker"; }
    [[nodiscard]] fs::path report() const { return folder_ / "report.txt"; }
    [[nodiscard]] fs::path results() const { return folder_ / "results.jsonl"; }

    static constexpr const char* treasure = "{\"points\": 20}\n";
    TemporaryFolder temporary_;
    const fs::path& folder_ = temporary_.path();
    grade::BuildDirectory workshop_;
};

std::string stage_file(const std::string& stage, const std::string& folder) {
    const std::string name = stage.substr(stage.find('_') + 1) + ".cpp";
    return std::string(RAYSTEPS_ROOT) + "/steps/" + stage + "/" + folder + "/" + name;
}

bool is_built(const std::string& stage) {
    return fs::exists(std::string(RAYSTEPS_BUILD) + "/seats/" + stage + ".o");
}

std::size_t ceiling(Grader& grader, const Attack& attack) {
    static std::map<std::string, std::size_t> of_stub;
    const std::string said = attack.said("ceiling", "as a stub");
    if (said != "as a stub") return std::stoul(said);
    const std::string stage = attack.stage();
    if (of_stub.count(stage) == 0)
        of_stub[stage] = grader
                             .grade({.name = "stub",
                                     .head = {{"stage", stage}},
                                     .text = read_text(stage_file(stage, "starter"))})
                             .passed.size();
    return of_stub[stage];
}

}  // namespace

TEST_CASE("a right answer has all cases, sealed, and a stub has those of nothing") {
    Grader grader;
    for (const std::string stage : {"step03_sphere", "step05_triangle", "step13_meshes"}) {
        if (!is_built(stage)) continue;
        INFO(stage);
        const Grade right = grader.grade({.name = "right",
                                          .head = {{"stage", stage}},
                                          .text = read_text(stage_file(stage, "reference"))});
        INFO(right.message);
        REQUIRE(right.compiled);
        CHECK(right.message.find("\nfailed") == std::string::npos);
        CHECK(right.passed.size() > 15);
        const Grade stub = grader.grade({.name = "stub",
                                         .head = {{"stage", stage}},
                                         .text = read_text(stage_file(stage, "starter"))});
        REQUIRE(stub.compiled);
        CHECK(stub.passed.size() < right.passed.size() / 2);
    }
}

TEST_CASE("a right trace has all cases, sealed and with a seed; a mistake has not") {
    Grader grader;
    const TemporaryFolder folder;
    const fs::path seed = folder.path() / "seed";
    std::ofstream(seed) << "9d0f5a37c1e86b24\n";
    setenv("RAYSTEPS_SEED_FILE", seed.c_str(), 1);
    const auto graded = [&](const std::string& stage, const std::string& text) {
        return grader.grade(
            {.name = stage, .head = {{"stage", stage}, {"file", "main.cpp"}}, .text = text});
    };
    const auto source = [](const std::string& file) { return read_text(RAYSTEPS_ROOT "/" + file); };
    for (const auto& [stage, right, wrong] :
         {std::array{"step03_sphere", "smallest_of_all", "color_of_the_last"},
          std::array{"step12_mirror", "own_recursion", "ray_goes_on"}}) {
        const auto answer = find_right_answer(RAYSTEPS_ROOT, stage + "_trace"s, right);
        REQUIRE(answer);
        const Grade all = graded(stage, answer->text);
        INFO(all.message);
        REQUIRE(all.compiled);
        CHECK(all.message.find("\nfailed") == std::string::npos);
        CHECK(all.passed.size() > 6);
        const auto mistakes = read_known_mistakes(RAYSTEPS_ROOT, stage + "_trace"s);
        const auto mistake = std::ranges::find(mistakes, wrong, &KnownMistake::name);
        REQUIRE(mistake != mistakes.end());
        const Grade some = graded(stage, source_of(RAYSTEPS_ROOT, stage + "_trace"s, *mistake));
        REQUIRE(some.compiled);
        CHECK(some.passed.size() < all.passed.size());
    }
    CHECK(graded("step03_sphere", source("steps/step03_sphere/starter/main.cpp")).compiled);
    unsetenv("RAYSTEPS_SEED_FILE");
}

TEST_CASE("a file that does not include its contract is refused, as it is by a check") {
    Grader grader;
    std::string text = read_text(stage_file("step03_sphere", "reference"));
    const auto graded = [&] { return grader.grade({.name = "file", .head = {}, .text = text}); };
    // In any order: <cmath> first, as some students write.
    text = "#include <cmath>\n" + text;
    CHECK(graded().compiled);
    const std::string include = "#include \"steps/step03_sphere/sphere.hpp\"\n";
    text.erase(text.find(include), include.size());
    const Grade without = graded();
    CHECK_FALSE(without.compiled);
    CHECK(without.message.find("sphere.cpp:") != std::string::npos);
}

namespace {

/// All whose names begin with one of these letters.
void attack_with(char first, char last) {
    Grader grader;
    const pid_t me = getpid();
    const char* only = std::getenv("RAYSTEPS_ATTACK");  // to look at one
    int count = 0;
    for (const Attack& attack : all_attacks()) {
        if (attack.name[0] < first || attack.name[0] > last) continue;
        if (only != nullptr && attack.name != only) continue;
        if (!is_built(attack.stage())) continue;  // stage 13 is not, without OpenMesh
        ++count;
        INFO(attack.name);
        CHECK(attack.head.contains("ceiling"));
        const std::size_t most = ceiling(grader, attack);
        const Grade grade = grader.grade(attack);
        INFO(grade.message);
        CHECK(grade.passed.size() <= most);
        CHECK(grade.message.find(attack.said("message", "")) != std::string::npos);
        const std::string compiles = attack.said("compiles", "yes");
        CHECK((compiles == "perhaps" || compiles == (grade.compiled ? "yes" : "no")));
        const std::string secret = attack.said("message without", "");
        CHECK((secret.empty() || grade.message.find(secret) == std::string::npos));
        CHECK(grade.time < longest_grading * grade::busy());
        CHECK(grade.processor_time < std::stod(attack.said("processor", "60")));
        CHECK(grader.is_unharmed());
        CHECK(grader.workers_left() == 0);
        CHECK(getpid() == me);
        std::printf("%-32s %2zu of %2zu cases, %4.1f s, processor %4.1f s\n", attack.name.c_str(),
                    grade.passed.size(), most, grade.time.count(), grade.processor_time);
        std::fflush(stdout);
    }
    CHECK((only != nullptr || count >= 30));
}

}  // namespace

// Three tests, which CI runs at the same time: most attacks wait for a limit.
TEST_CASE("attacks a to h earn nothing and do no harm") {
    attack_with('a', 'h');
}
TEST_CASE("attacks i to r earn nothing and do no harm") {
    attack_with('i', 'r');
}
TEST_CASE("attacks s to z earn nothing and do no harm") {
    attack_with('s', 'z');
}
