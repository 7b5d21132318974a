// The pages of docs/ as a site, written by mkdocs.
#pragma once

#include "common/system/files.hpp"

#include <string>

namespace rt {

// Where the site is in a project, and what its links to the project's files begin with.
inline constexpr const char* site_of_clone = "build/book";
inline constexpr const char* site_of_handout = "docs/book";
inline constexpr const char* project_from_site = "../..";

/// Writes the site of the project's pages into a folder, which appears whole or not at all. An
/// older site of this function is replaced; throws InputError if anything else is there, or if
/// mkdocs, its theme or KaTeX is not installed, and ProgramError if a page cannot be set.
///
/// `source` is the address below which links lead to the project's files, or empty: they become
/// plain text.
void write_site(const fs::path& project, const fs::path& destination, const std::string& source);

/// The address of the project's files on GitHub, if it is a clone from there; else empty.
[[nodiscard]] std::string address_on_github(const fs::path& project);

// `./course book --pdf DIR`: the stages' pages, printed.

/// Throws InputError if print_pages could not write to this folder, because something is there, or
/// if Chromium or poppler's pdfunite is not installed.
void check_printing(const fs::path& destination);

/// Prints each stage's page of the site as a PDF, stepNN_name.pdf, and all of them as course.pdf,
/// in the reader's language if the site has it, into a folder, which appears whole or not at all.
/// Throws InputError as check_printing does, and ProgramError if one of the programs fails.
void print_pages(const fs::path& site, const fs::path& destination);

}  // namespace rt
