// What was handed in: folders and archives, of strangers.
#pragma once

#include "common/course/grade/compile.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt::grade {

/// A student's folder or archive, unopened.
struct Envelope {
    std::string student;  ///< its name, made fit to be a folder's
    std::filesystem::path place;
};

/// Each of the places is a submission, or a folder of submissions, in which a folder of results is
/// none, of this run or another. In the order of their names, which differ. Throws InputError if
/// one is not there, or if there is none.
[[nodiscard]] std::vector<Envelope> find_envelopes(const std::vector<std::filesystem::path>& places,
                                                   const std::filesystem::path& results = {});

/// What a submission holds, by stage.
struct HandedIn {
    std::map<int, std::string> files;
    std::map<int, std::string> words;  ///< of two files for one stage, say
    std::string words_on_all;          ///< of an archive that cannot be opened
};

/// The files of the thirteen names, wherever they are: of several, the one in a folder "student",
/// else the one least deep. No link is followed, no archive opened but by a sealed tool. Throws
/// ProgramError or filesystem_error if it is we who fail.
[[nodiscard]] HandedIn take_in(const Workshop& workshop, const Envelope& envelope);

}  // namespace rt::grade
