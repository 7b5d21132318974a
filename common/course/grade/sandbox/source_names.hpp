// The stage of a file, by its name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rt::grade {

enum class Fit {
    none,     ///< "notes.cpp"
    suspect,  ///< a near miss: "shpere.cpp", "sphere.cpp.txt", "sphere.cpp~". Reported, and not
              ///< graded.
    near,     ///< renamed by people and browsers: "Sphere.cpp", "sphere.cc", "sphere (1).cpp"
    exact,    ///< "sphere.cpp"
};

struct Named {
    int stage = 0;  ///< 0 of "main.cpp": its folder names the stage
    Fit fit = Fit::none;
    bool is_trace = false;  ///< "main.cpp", "sphere_main.cpp", "step03_main.cpp"
};

/// The stage that a file with this name belongs to, and which of its files it is.
[[nodiscard]] Named named_for(const std::string& file_name);

/// The student of a file, by the name from a learning platform.
struct Labeled {
    std::string student;
    std::string name;  ///< the student's own name for the file; empty for a folder
    bool late = false;
    std::string number;  ///< Canvas's, of the file; empty for Moodle's
};

/// The parts of a name by Moodle or Canvas; nothing for another name.
[[nodiscard]] std::optional<Labeled> label(const std::string& name);

/// The stage that a folder names: "step03_sphere", "Stage 3", "03-sphere", "sphere".
[[nodiscard]] std::optional<int> stage_of_folder(const std::string& folder_name);

/// True if the name has the extension of a C++ source.
[[nodiscard]] bool is_source(const std::string& file_name);

/// True if the name has the extension of an archive, supported or not.
[[nodiscard]] bool is_archive(const std::string& file_name);

[[nodiscard]] std::string without_archive_ending(std::string name);

/// Files that systems add to folders and archives: .git, __MACOSX, "._x".
[[nodiscard]] bool is_litter(const std::string& file_name);

}  // namespace rt::grade
