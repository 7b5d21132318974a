// `./course book`: the pages of docs/ as a site, with search, hints and contracts in the pages.
#pragma once

#include "common/course/view/http.hpp"
#include "common/system/files.hpp"

#include <atomic>
#include <optional>
#include <string>

namespace rt {

struct BookSettings {
    fs::path project;
    std::optional<std::string> out;  ///< the folder for the site; without it, it is served
    std::optional<std::string> pdf;  ///< the folder for the printed pages; nothing is served then
    std::string source;              ///< where links to the project's files lead; empty: to GitHub,
                                     ///< if the project is a clone from there
};

/// Writes the site and prints its name; or serves it, prints its address, and returns at Ctrl-C. A
/// hand-out contains the site already. Throws InputError or ProgramError if it cannot be written.
/// Returns 0.
int book(const BookSettings& settings);

// The student's own functions, called for a figure of the book.

/// The script with the addresses of own_answer and own_files, as seen from itself.
[[nodiscard]] Response own_answer_address();

/// The names and the times of all the student's files: another text after one was saved.
[[nodiscard]] Response own_files();

/// The bytes of the answer to `question`, in hexadecimal digits, of the student's file of `stage`,
/// in double (`precision` 0) or float. Builds the file if it has changed. Throws Refusal where
/// there is no answer, with the reason in the words of `check`. The call, and all that it starts,
/// ends when `cancelled` becomes true.
[[nodiscard]] Response own_answer(const Request& request, const std::atomic<bool>& cancelled);

}  // namespace rt
