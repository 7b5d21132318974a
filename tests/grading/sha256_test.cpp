// The hash that identifies a submitted file.
#include "common/course/grade/results/sha256.hpp"

#include "common/system/hash.hpp"

#include "tests/kit/catch.hpp"

namespace rt::grade {

// The examples of FIPS 180-4 and of NIST's test vectors (SHA256ShortMsg, SHA256LongMsg).
TEST_CASE("a text's SHA-256 is that of the standard's examples") {
    CHECK(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
          "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    CHECK(sha256("abcdefghbcdefghicdefghijdefghijkefghijklfghijklmghijklmnhijklmnoijklmnopjklmnopqk"
                 "lmnopqrlmnopqrsmnopqrstnopqrstu") ==
          "cf5b16a778af8380036ce59e7b0492370b249b11e8f07a51afac45037afee9d1");
    CHECK(sha256("\xd3") == "28969cdfa74a12c82f3bad960b0b000aca2ac329deea5c2328ebc6f2ba9802c1");
    CHECK(sha256(std::string(1000000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

// 55 bytes are padded within their block; 56, and 64, with one block more.
TEST_CASE("texts of every length around a block's have a SHA-256 each") {
    CHECK(sha256(std::string(55, 'a')) ==
          "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    CHECK(sha256(std::string(56, 'a')) ==
          "b35439a4ac6f0948b6d6f9e3c6af0f5f590ce20f1bde7090ef7970686ec6738a");
    CHECK(sha256(std::string(64, 'a')) ==
          "ffe054fe7ae0cb6dc65c3af9b61d5209f439851db43d0ba5997337df154668eb");
}

// The values are of the test vectors in draft-eastlake-fnv.
TEST_CASE("a text's FNV-1a hash is that of its authors' examples, in parts too") {
    CHECK(fnv1a("") == 0xcbf29ce484222325u);
    CHECK(fnv1a("a") == 0xaf63dc4c8601ec8cu);
    CHECK(fnv1a("foobar") == 0x85944171f73967e8u);
    CHECK(fnv1a("bar", fnv1a("foo")) == fnv1a("foobar"));
}

TEST_CASE("texts of one FNV-1a hash are different files") {
    // A lattice of 20 dimensions finds such a comment for any file in a second.
    const std::string right = "intersect: the right one";
    const std::string other =
        "\x65\x72\x62\x6f\x51\xc0\x2e\x2e\x2a\x6b\xf0\x5b\x25\x49\x26\x0c\x49\x23\x20\x28\x36\x25"
        "\xef\x17";
    REQUIRE(fnv1a(right) == fnv1a(other));
    CHECK(sha256(right) != sha256(other));
}

TEST_CASE("texts that are cut elsewhere are other texts") {
    CHECK(sha256_of_all("ab", "c") != sha256_of_all("a", "bc"));
    CHECK(sha256_of_all("ab", "c") == sha256_of_all("ab", "c"));
    CHECK(sha256_of_all("a") != sha256_of_all("a", ""));
}

}  // namespace rt::grade
