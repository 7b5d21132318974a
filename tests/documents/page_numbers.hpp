// The numbers that pages print, each computed from what the page is about.
#pragma once

#include "tests/kit/verdict.hpp"

#include <string>
#include <vector>

namespace rt {

/// A number as a page prints it.
struct Printed {
    int line;
    std::string text;
    double value;
    double last_digit;  ///< the weight of its last digit
    std::string unit;   ///< "°", "%" or nothing
};

/// A computed number, with the unit that is printed.
struct Known {
    std::string what;
    double value;
    std::string unit = "";
};

using Knowledge = std::vector<Known>;

constexpr double degree = double(pi) / 180;

// CR's printed minimum t of a shadow ray and of a reflected ray, and its listing's factor for
// vertices.
constexpr double cr_shadow_start = 0.001;
constexpr double cr_mirror_start = 0.0001;
constexpr double cr_mesh_scale = 0.0001;

/// The printed numbers of a line.
std::vector<Printed> numbers_in(const std::string& text, int line = 0);

/// The text of a file of the project.
std::string content(const std::string& name);

/// The page has the sentence, which may run across lines.
Verdict says(const std::string& page, const std::string& sentence);

std::string decimals(double value, int digits);

/// The number between these words in a source.
double said_in(const std::string& file, const std::string& before, const std::string& after);

// The numbers of a page.
Knowledge stage1();
Knowledge stage2();
Knowledge stage3();
Knowledge stage4();
Knowledge stage8();
Knowledge stage9();
Knowledge stage10();
Knowledge stage11();
Knowledge stage12();
Knowledge stage13();
Knowledge debugging();

}  // namespace rt
