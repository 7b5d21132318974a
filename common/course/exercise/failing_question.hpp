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

/// Keeps the name of the case that a check of the stage explains.
void remember_shown_case(int stage, const std::string& name);

/// That name, of the last check; empty if there is none.
[[nodiscard]] std::string shown_case(int stage);

/// That of the case with this name, if it fails and has one; or else of the first such case.
[[nodiscard]] std::optional<FailingQuestion> failing_question(std::vector<CaseResult> results,
                                                              const std::string& shown = "");

}  // namespace rt
