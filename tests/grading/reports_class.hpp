// A handmade class with known marks.
#pragma once

#include "common/course/grade/results/results.hpp"
#include "common/system/files.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace rt::grade {

/// A possible folder name in an untrusted archive: a formula, a tag, quotes, a line end.
inline const std::string odd = "=cmd|\"<b>&\n";

/// Output of untrusted code that is not UTF-8.
inline const std::string no_utf8 = "got: \xff\xc3(";

/// True if the text contains the part.
[[nodiscard]] inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A folder of results that is removed at the end of its scope.
struct Results {
    TemporaryFolder temporary;
    std::filesystem::path folder = temporary.path();
};

/// Two students, stages 4 and 5, of 2 and 4 points. The odd one has 1 point of stage 4, and stage 5
/// is refused; zoe did not submit stage 4, and has 3 points of stage 5.
[[nodiscard]] std::vector<Mark> class_of_two();

}  // namespace rt::grade
