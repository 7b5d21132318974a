// The known mistakes of a stage and its other right answers, all in one worker.
#pragma once

#include "common/contract/call.hpp"
#include "common/course/authoring/known_mistakes.hpp"
#include "common/system/files.hpp"

#include <cstdlib>

namespace rt::contract {

struct Answers {
    std::filesystem::path project;
    std::string stage;
    std::string worker;  ///< its program

    [[nodiscard]] std::vector<KnownMistake> mistakes() const {
        return read_known_mistakes(project, stage);
    }

    /// The names of the other right answers.
    [[nodiscard]] std::vector<std::string> alternatives() const {
        std::vector<std::string> names;
        for (const auto& file : files_in(project / "tests/alternatives" / stage, ".cpp"))
            names.push_back(file.stem().string());
        return names;
    }

    /// The worker as this answer. Only one at a time is used.
    [[nodiscard]] Asked as(const std::string& name) const {
        setenv("RAYSTEPS_ANSWER", name.c_str(), 1);
        return Asked(worker);
    }
};

}  // namespace rt::contract
