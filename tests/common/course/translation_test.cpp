// Sentences in the reader's language.
#include "common/system/translation.hpp"

#include "common/system/files.hpp"

#include "tests/kit/catch.hpp"

#include <cstdlib>
#include <string>
#include <vector>

using namespace rt;

namespace {

constexpr const char* catalogue = R"(msgid ""
msgstr ""
"Content-Type: text/plain; charset=UTF-8\n"

#. a comment
msgid "a cone"
msgstr "un cône"

#, no-wrap
msgid ""
"the \"first\" line\n"
"the second\n"
msgstr ""
"la « première »\n"
"la seconde\n"

#, fuzzy, no-wrap
#| msgid "a spher"
msgid "a sphere"
msgstr "une sfère"

msgid "a plane"
msgstr ""

msgid "{some} of {all} pass"
msgstr "sur {all}, {some} réussissent"

msgid "{what}, of {heading}"
msgstr "{what}, de {heading}"

msgid "hit at {t}"
msgstr "intersection à {t}"

msgid "{what}, but hit at {t}"
msgstr "{what}, mais intersection à {t}"

#~ msgid "a square"
#~ msgstr "un carré"
)";

void read() {
    const TemporaryFolder folder;
    write_text(folder.path() / "fr.po", catalogue);
    read_translations(folder.path() / "fr.po");
    read_translations(folder.path() / "none.po");
}

}  // namespace

TEST_CASE("a sentence is translated, and English without a translation") {
    read();
    CHECK(tr("a cone") == "un cône");
    CHECK(tr("the \"first\" line\nthe second\n") == "la « première »\nla seconde\n");
    for (const char* english : {"a sphere", "a plane", "a square", "a box", ""})
        CHECK(tr(english) == english);
}

TEST_CASE("values stand in the places of the translation") {
    read();
    CHECK(tr("{some} of {all} pass", {{"some", "{all}"}, {"all", "4"}}) ==
          "sur 4, {all} réussissent");
    CHECK(tr("{a} and {b}", {{"a", "1"}}) == "1 and {b}");
}

TEST_CASE("a text that was put together elsewhere is translated with its values") {
    read();
    CHECK(tr_text("a cone") == "un cône");
    CHECK(tr_text("2 of 3 pass") == "sur 3, 2 réussissent");
    CHECK(tr_text("hit at 4") == "intersection à 4");
    CHECK(tr_text("a cone, but hit at 1, but hit at 4") ==
          "un cône, mais intersection à 1, mais intersection à 4");
    for (const char* english :
         {"hit at ", " of 3 pass", "a hit at 4", "Sphere{.radius = 4}", "1, of 2", ""})
        CHECK(tr_text(english) == english);
}

TEST_CASE("paragraphs are translated one by one") {
    read();
    CHECK(paragraphs_translated("a\nbox\n\nthe \"first\" line\nthe second\n\n") ==
          "a\nbox\n\nla « première »\nla seconde\n\n");
}

TEST_CASE("the language is that of the environment") {
    const std::vector<const char*> names = {"RAYSTEPS_LANG", "LC_ALL", "LC_MESSAGES", "LANG"};
    for (const char* name : names) unsetenv(name);
    CHECK(language_of_environment().empty());
    setenv("LANG", "fr_FR.UTF-8", 1);
    CHECK(language_of_environment() == "fr");
    setenv("LC_MESSAGES", "de", 1);
    CHECK(language_of_environment() == "de");
    setenv("LC_ALL", "C.UTF-8", 1);
    CHECK(language_of_environment() == "C");
    setenv("RAYSTEPS_LANG", "fr", 1);
    CHECK(language_of_environment() == "fr");
    setenv("RAYSTEPS_LANG", "", 1);
    CHECK(language_of_environment() == "C");
    for (const char* name : names) unsetenv(name);
}
