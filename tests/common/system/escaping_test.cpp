// Text of unknown content in messages and URLs.
#include "common/system/escaping.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;

TEST_CASE("a quoted text is short, and printable ASCII") {
    CHECK(rt::quoted("") == "\"\"");
    CHECK(rt::quoted("a b~") == "\"a b~\"");
    CHECK(rt::quoted("\x1B[31m\n\x7F") == "\"\\x1B[31m\\x0A\\x7F\"");
    CHECK(rt::quoted("é") == "\"\\xC3\\xA9\"");
    CHECK(rt::quoted(std::string(40, 'a')) == '"' + std::string(40, 'a') + '"');
    CHECK(rt::quoted(std::string(41, 'a')) == '"' + std::string(40, 'a') + "...\"");
}

TEST_CASE("percent-encoding keeps RFC 3986's unreserved characters alone") {
    CHECK(percent_encoded("a_b-1.png~") == "a_b-1.png~");
    CHECK(percent_encoded("../é\n") == "..%2F%C3%A9%0A");
    CHECK(percent_encoded("100 %") == "100%20%25");
}

TEST_CASE("a word for the shell is in quotes if it needs any") {
    CHECK(shell_word("a-1/b_2.png") == "a-1/b_2.png");
    CHECK(shell_word("my scene.rt") == "'my scene.rt'");
    CHECK(shell_word("it's") == "'it'\\''s'");
    CHECK(shell_word("") == "''");
}
