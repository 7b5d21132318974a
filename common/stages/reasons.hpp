// Parts of messages that one program prints and another searches for.
#pragma once

namespace rt {

/// The start of the sentence on a worker that ended, or was ended, before it answered.
inline constexpr const char* no_answer_start = "Your code ";

/// All cases of a suite together took too long.
inline constexpr const char* too_long_a_suite = "took longer than all cases may take";

/// The suite was ended before it reached the case.
inline constexpr const char* not_reached = "was not reached: the cases before it took too long";

/// The worker tried a system call that its sandbox does not allow.
inline constexpr const char* forbidden_operation = "tried a forbidden operation";

/// The end of the message about a function that is not written yet.
inline constexpr const char* not_written = " is not written yet";

}  // namespace rt
