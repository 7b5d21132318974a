// Objects whose names are made to hold up who reads them.
#include "common/course/grade/judging/symbols.hpp"
#include "common/system/files.hpp"
#include "common/system/process.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

namespace {

/// The sentence about an object of this assembler text, for a stage that has no functions.
std::string sentence_on(const std::string& text) {
    const TemporaryFolder folder;
    const std::string source = folder.path() / "object.s";
    const std::string made = folder.path() / "object.o";
    write_text(source, ".data\n" + text + "\n");
    REQUIRE(run_captured({"c++", "-c", source, "-o", made}, std::chrono::minutes(1)).status == 0);
    const auto object = grade::parse_object(read_text(made));
    return object ? grade::foreign_symbol(*object, {}) : "cannot be read";
}

}  // namespace

TEST_CASE("a call of the project is recognized by its mangled name") {
    const std::string rest =
        ", which it does not define itself, and which this stage may not call: the stage's page "
        "lists the allowed functions.";
    CHECK(sentence_on(".quad _ZN2rt5otherEv") == "Your file calls rt::other()" + rest);
    CHECK(sentence_on(".quad _Z5otherN2rt3f643RayE") ==
          "Your file calls other(rt::f64::Ray)" + rest);
    for (const char* other : {"_Z12rtabcdefghijv", "_ZN5start5otherEv", "a2rt", "sqrt"})
        CHECK(sentence_on(std::string(".quad ") + other).empty());
}

TEST_CASE("placement new, which a header defines, is nobody's replacement; operator new is") {
    for (const std::string name : {"_ZnwmPv", "_ZnamPv", "_ZdlPvS_", "_ZdaPvS_"})
        CHECK(sentence_on(".weak " + name + "\n.text\n" + name + ": ret").empty());
    for (const char* other :
         {".globl _ZnwmPv\n.text\n_ZnwmPv: ret", ".weak _Znwm\n.text\n_Znwm: ret"})
        CHECK(sentence_on(other).find("which all programs share") != std::string::npos);
}

TEST_CASE("a name that stands for gigabytes is not demangled") {
    // P<B, B>, and 20 more types: each is P of the one before, twice.
    std::string name = "_Z1fN2rt1BE1PIS0_S0_E";
    for (const char last : std::string("23456789ABCDEFGHIJKLMNOPQRSTU"))
        name += std::string("S1_IS") + last + "_S" + last + "_E";
    CHECK(sentence_on(".quad " + name).starts_with("Your file calls _Z1fN2rt1BE1PI"));
    CHECK(sentence_on(".globl " + std::string(100000, 'x') + "\n.text\n" +
                      std::string(100000, 'x') + ":")
              .size() < 1000);
}

TEST_CASE("names that share their ends are read up to a limit") {
    // Each macro calls the next with its name, and with a longer one: names of 1 to 8192 letters.
    constexpr int depth = 13;
    std::string text;
    for (int i = 0; i < depth; ++i) {
        const std::string next = "m" + std::to_string(i + 1);
        text += ".macro m" + std::to_string(i) + " n\n" + next + " \\n\n" + next + " \\n\\()" +
                std::string(std::size_t(1) << i, 'a') + "\n.endm\n";
    }
    text += ".macro m13 n\n.globl \\n\n\\n: .byte 0\n.endm\nm0 a\n";
    CHECK(sentence_on(text) == "cannot be read");
}
