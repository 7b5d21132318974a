// `./course book --pdf DIR`: the stages' pages, printed.
#pragma once

#include <filesystem>

namespace rt {

/// Throws InputError if print_pages could not write to this folder, because something is there, or
/// if Chromium or poppler's pdfunite is not installed.
void check_printing(const std::filesystem::path& destination);

/// Prints each stage's page of the site as a PDF, stepNN_name.pdf, and all of them as course.pdf,
/// in the reader's language if the site has it, into a folder, which appears whole or not at all.
/// Throws InputError as check_printing does, and ProgramError if one of the programs fails.
void print_pages(const std::filesystem::path& site, const std::filesystem::path& destination);

}  // namespace rt
