// Which stage a file is meant for, by its name.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

enum class Fit {
    none,     ///< "notes.cpp"
    suspect,  ///< nearly: "shpere.cpp", "sphere.cpp.txt". Reported, and not taken.
    near,     ///< as people and browsers rename: "Sphere.cpp", "sphere.cc", "sphere (1).cpp"
    exact,    ///< "sphere.cpp"
};

struct Named {
    int stage = 0;
    Fit fit = Fit::none;
};

/// The stage that a file of this name is for.
[[nodiscard]] Named named_for(const std::string& file_name);

/// Whether the name ends as C++ does.
[[nodiscard]] bool is_source(const std::string& file_name);

/// Whether the name ends as an archive's does, of a kind that is read or not.
[[nodiscard]] bool is_archive(const std::string& file_name);

/// The name without the ending of an archive.
[[nodiscard]] std::string without_archive_ending(std::string name);

/// What systems leave in folders and archives, and no student writes: .git, __MACOSX, "._x".
[[nodiscard]] bool is_litter(const std::string& file_name);

/// The text in lower case, of ASCII's letters.
[[nodiscard]] std::string lower(std::string text);

}  // namespace rt::grade
