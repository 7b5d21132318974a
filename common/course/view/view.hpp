// `./course view`: a page that shows the pictures while the student edits the code.
#pragma once

#include "common/system/files.hpp"

#include <chrono>
#include <functional>
#include <string>

namespace rt {

struct ViewSettings {
    fs::path project;           ///< contains the scenes, and the student's files, which are
                                ///< watched
    fs::path build;             ///< contains stepNN_name and stepNN_name_reference_program
    int stage = 1;              ///< the first stage to show
    std::string language = "";  ///< of the page, as in lang/; empty for English
    int port = 0;               ///< 0: any free port
    std::chrono::seconds render_limit{60};

    /// Builds a stage's programs. Returns the first error of the compiler, or an empty text. Called
    /// when a stage is shown, and whenever a student's file is saved, in a separate thread, one
    /// call at a time. Without it, the student must build by hand to see a change.
    std::function<std::string(int stage)> rebuild = nullptr;
};

/// Serves the page to this machine only, prints its address, and returns at Ctrl-C. Throws
/// InputError if it cannot start.
int view(const ViewSettings& settings);

}  // namespace rt
