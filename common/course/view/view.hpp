// `./course view`: one page that shows the pictures while they are being made right.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

namespace rt {

struct ViewSettings {
    std::filesystem::path project;  ///< its scenes, and the students' files that are watched
    std::filesystem::path build;    ///< holds stepNN_name and stepNN_name_of_reference
    int stage = 1;                  ///< shown first
    int port = 0;                   ///< 0: one that is free
    std::chrono::seconds render_limit{60};

    /// Builds a stage's programs: what the compiler said first that is wrong, nothing if all is
    /// well. Called when a stage is looked at, and whenever a student's file is saved, in a thread
    /// of its own, one at a time. Without it, who wants to see a change builds it himself.
    std::function<std::string(int stage)> rebuild = nullptr;
};

/// Serves the page to this machine only, prints its address, and returns at Ctrl-C. Throws
/// InputError if it cannot start.
int view(const ViewSettings& settings);

}  // namespace rt
