// The first question that a suite reports as answered wrongly.
#pragma once

#include "common/course/build/suite_report.hpp"
#include "common/system/process.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rt {

/// A call of a function, or the pixel of a scene.
struct FailingQuestion {
    std::string case_name;
    std::string call;     ///< "intersect(Ray{…}, Sphere{…})", or empty
    std::string scene;    ///< the text of the scene, or empty
    Command options;      ///< with which it is rendered: "--term", "specular"
    std::string pixel{};  ///< "ROW,COLUMN" of the scene's picture
};

/// That of the first failing case whose failure has one.
[[nodiscard]] std::optional<FailingQuestion> failing_question(
    const std::vector<CaseResult>& results);

}  // namespace rt
