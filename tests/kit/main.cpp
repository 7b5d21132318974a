// Catch2's main, compiled once for all suites.
#if __has_include(<catch2/catch_session.hpp>)
#include <catch2/catch_session.hpp>

int main(int argc, char** argv) {
    return Catch::Renderer().run(argc, argv);
}
#else
#define CATCH_CONFIG_MAIN
#define CATCH_CONFIG_CONSOLE_WIDTH 120  // a line to paste should stay one
#include <catch2/catch.hpp>
#endif
