// The names of known mistakes of `trace`, by everything that they fail.
#include "common/course/exercise/trace_mistakes.hpp"
#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <filesystem>

using namespace rt;

namespace {

/// Digests of failures.
const std::string red_for_blue = "0000000100aa";
const std::string black = "0000000200bb";
const std::string white = "0000000200cc";  // the same question, another answer

/// The failures of six other questions.
const std::string six =
    "000000110011 000000120011 000000130011 000000140011 000000150011 000000160011";

/// Three mistakes: the second also fails what the first fails, in the same way.
const std::string known =
    "# A comment.\n"
    "mistake farthest: You keep the farthest hit: t is compared the wrong way round.\n" +
    red_for_blue + "\nmistake first_hit: You return the first hit.\n" + red_for_blue + " " + black +
    "\nmistake no_torch: No torch.\n" + six + " " + black + "\n";

CaseResult passes(const std::string& name) {
    return {.name = name, .passed = true};
}

CaseResult fails(const std::string& name, const std::string& digest) {
    return {.name = name, .failures = digest};
}

/// The names and sentences of the mistakes, or nothing.
std::string recognized(const std::vector<CaseResult>& cases, const std::string& file = known) {
    const TemporaryFolder folder(std::filesystem::temp_directory_path());
    const std::filesystem::path path = folder.path() / "trace.txt";
    write_text(path, file);
    std::string names;
    for (const TraceMistake& each : recognized_trace_mistakes(path, cases))
        names += (names.empty() ? "" : "; ") + each.name +
                 (each.is_certain ? ": " : " probably: ") + each.sentence;
    return names;
}

const std::string farthest =
    "farthest: You keep the farthest hit: t is compared the wrong way round.";
const std::string first_hit = "first_hit: You return the first hit.";
const std::string closest = "the closest is seen (M1)";
const std::string behind = "a sphere behind the eye is not seen";

}  // namespace

TEST_CASE("a mistake of trace has its name if the same cases fail in the same way") {
    CHECK(recognized({fails(closest, red_for_blue), passes(behind)}) == farthest);
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, black)}) == first_hit);
    CHECK(recognized({fails(behind, black), fails(closest, red_for_blue)}) == first_hit);
}

TEST_CASE("a trace that fails fewer cases, more cases or others has no known mistake's name") {
    CHECK(recognized({passes(closest), passes(behind)}).empty());
    CHECK(recognized({}).empty());
    CHECK(recognized({passes(closest), fails(behind, black)}).empty());
    CHECK(recognized({fails(closest, red_for_blue), fails("another", "0000000300dd")}).empty());
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, black),
                      fails("another", "0000000300dd")})
              .empty());
}

TEST_CASE("a trace that fails the questions of a known mistake with other answers has no name") {
    CHECK(recognized({fails(closest, red_for_blue), fails(behind, white)}).empty());
    CHECK(recognized({fails(closest, "0000000100ab")}).empty());
}

TEST_CASE("a mistake is probable if it fails nearly the same questions, and one side no others") {
    const std::string probable = "no_torch probably: No torch.";
    CHECK(recognized({fails(closest, six)}) == probable);
    CHECK(recognized({fails(closest, six), fails(behind, black)}) == "no_torch: No torch.");
    CHECK(recognized({fails(closest, six), fails(behind, black + " " + red_for_blue)}) == probable);
    CHECK(recognized({fails(closest, six), fails(behind, white)}).empty());
    CHECK(recognized({fails(closest, six.substr(0, 38))}).empty());
}

TEST_CASE("two mistakes are recognized together where each explains its part") {
    const std::string both = "000000030033 000000040044";
    const std::string one = "000000110011 000000120011 000000130011 " + both;
    const std::string other = "000000210022 000000220022 000000230022 " + both;
    const std::string two = "mistake one: One.\n" + one + "\nmistake other: Other.\n" + other;
    const std::string names = "one probably: One.; other probably: Other.";
    CHECK(recognized({fails(closest, one + " " + other)}, two) == names);
    // A question that both fail gets the answer of both mistakes at once, which can be the right
    // one.
    const std::string alone = one.substr(0, 38) + " " + other.substr(0, 38);
    CHECK(recognized({fails(closest, alone + " 000000030077")}, two) == names);
    CHECK(recognized({fails(closest, alone)}, two) == names);
    // A failure of neither, one of another answer, and too little of the second.
    CHECK(recognized({fails(closest, alone + " 000000990099")}, two).empty());
    CHECK(recognized({fails(closest, alone + " 000000210023")}, two).empty());
    CHECK(recognized({fails(closest, alone.substr(0, 64))}, two).empty());
    // A third one explains as much as the second.
    CHECK(recognized({fails(closest, alone)}, two + "\nmistake third: Third.\n" + other).empty());
    CHECK(recognized({fails(closest, alone)}, two + "\nmistake third: Other.\n" + other) == names);
}

TEST_CASE("the picture, which depends on everything, does not count for the name of a mistake") {
    const CaseResult picture = fails("the picture of the stage, by this trace (CR §2.1)", black);
    CHECK(recognized({fails(closest, red_for_blue), picture}) == farthest);
    CHECK(recognized({passes(closest), picture}).empty());
}

TEST_CASE("a stage without known mistakes of trace names none") {
    const std::vector<CaseResult> cases = {fails(closest, red_for_blue)};
    CHECK(recognized(cases, "").empty());
    CHECK(recognized(cases, "# A comment.\n").empty());
    CHECK(recognized_trace_mistakes("no/such/trace.txt", cases).empty());
}
