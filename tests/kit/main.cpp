// Catch2's main, where its library cannot be linked: compiled once for all suites.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
