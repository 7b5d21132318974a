// What was handed in: folders and archives, of strangers.
#pragma once

#include "common/course/grade/compile.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// A file, a folder or an archive of one student's.
struct Piece {
    std::filesystem::path place;
    std::string
        name;  ///< as the student called it, without what a learning platform puts before it
};

/// All of a student's, unopened.
struct Envelope {
    std::string student;  ///< fit to be a folder's name
    std::vector<Piece> pieces;
};

/// What a submission holds, by stage.
struct HandedIn {
    std::map<int, std::string> files;
    std::map<int, std::string> words;  ///< of two files for one stage, of names that nearly fit
    std::string words_on_all;          ///< of an archive that cannot be opened
};

/// The files of the thirteen names, wherever they are, in archives too. Of several, those whose
/// name is near go last ("Sphere.cpp"), and before them those in a folder "tests" or "build"; else
/// the one in a folder "student" goes first, else the one least deep. No link is followed, no
/// archive opened but by a sealed tool. Throws ProgramError or filesystem_error if it is we who
/// fail.
[[nodiscard]] HandedIn take_in(const Workshop& workshop, const Envelope& envelope);

}  // namespace rt::grade
