// `./course book --pdf DIR`: the stages' pages, printed.
#pragma once

#include <filesystem>

namespace rt {

/// Prints each stage's page of the site as a PDF, stepNN_name.pdf, and all of them as course.pdf,
/// into a folder, which appears whole or not at all. Throws InputError if anything is there, or if
/// Chromium or poppler's pdfunite is not installed, and ProgramError if one of them fails.
void print_pages(const std::filesystem::path& site, const std::filesystem::path& destination);

}  // namespace rt
