// My program beside the reference's: their pictures, and their stories of one pixel.
#pragma once

#include "common/course/process.hpp"

namespace rt {

/// Two programs of a stage that are given the same words.
struct Contest {
    int stage;
    bool all_mine;  ///< every stage is the student's that he has started, not only this one
    Command words;  ///< a scene and options of the programs
};

/// `./course compare`: both pictures and their difference, in renders/ and on a terminal. Returns 0
/// if they agree, else 1.
int compare_pictures(const Contest& contest);

/// `./course explain`: both stories of the pixel "ROW,COLUMN"; if it is empty, of the middle of the
/// largest cluster of pixels that differ. Returns 0.
int explain_pixel(const Contest& contest, std::string pixel);

}  // namespace rt
