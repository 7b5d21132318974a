// The known mistakes of a stage and its other right answers, all in one worker.
#pragma once

#include "common/contract/call.hpp"
#include "common/contract/probes.hpp"
#include "common/course/authoring/known_mistakes.hpp"
#include "common/system/process.hpp"

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>

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
        for (const RightAnswer& right : read_right_answers(project, stage))
            names.push_back(right.name);
        return names;
    }

    /// The worker as this answer. Only one at a time is used.
    [[nodiscard]] Asked as(const std::string& name) const {
        setenv("RAYSTEPS_ANSWER", name.c_str(), 1);
        return Asked(worker);
    }

    /// The results of this program, the suite linked to all answers, with this answer: of all its
    /// cases, or of those that Catch2's words select. One that does not end is stopped.
    [[nodiscard]] static CaseResults results(const std::string& suite, const std::string& name,
                                             const std::string& report,
                                             const std::vector<std::string>& words = {}) {
        constexpr std::chrono::minutes limit{5};
        std::filesystem::remove(report);
        setenv("RAYSTEPS_REPORT", report.c_str(), 1);
        setenv("RAYSTEPS_ANSWER", name.c_str(), 1);
        std::vector<std::string> command = {suite};
        command.insert(command.end(), words.begin(), words.end());
        const ProcessResult ending = run_captured(command, limit);
        unsetenv("RAYSTEPS_REPORT");
        if (ending.out_of_time) std::cerr << name << ": the suite was stopped\n";
        return read_case_results(content_of(report));
    }
};

}  // namespace rt::contract
