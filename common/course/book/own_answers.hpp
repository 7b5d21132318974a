// The student's own functions, called for a figure of the book.
#pragma once

#include "common/course/view/http.hpp"

namespace rt {

/// The script that tells the figures where own_answer is, as seen from itself.
[[nodiscard]] Response own_answer_address();

/// The bytes of the answer to `question`, in hexadecimal digits, of the student's file of `stage`,
/// in double (`precision` 0) or float. Builds the file if it has changed. Throws Refusal where
/// there is no answer, with the reason in the words of `check`.
[[nodiscard]] Response own_answer(const Request& request);

}  // namespace rt
