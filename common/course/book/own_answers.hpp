// The student's own functions, called for a figure of the book.
#pragma once

#include "common/course/view/http.hpp"

#include <atomic>

namespace rt {

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
