// Comparison of the student's program with the reference: the pictures, and the explanations of one
// pixel.
#pragma once

#include "common/system/process.hpp"

namespace rt {

/// Two programs of a stage that are run with the same arguments.
struct ComparisonRequest {
    int stage;
    bool all_mine;  ///< use the student's files of all started stages, not only of this one
    std::string references;  ///< of these: "3;5", or "all"
    Command words;           ///< a scene and program options
};

/// `./course compare`: writes both pictures and their difference to renders/, and shows them on a
/// terminal. Returns 0 if they agree, else 1. Throws InputError if the student's program takes
/// longer than ten seconds, and twenty times as long as the reference's.
int compare_pictures(const ComparisonRequest& contest);

/// `./course explain`: prints both explanations of the pixel "ROW,COLUMN"; if it is empty, of the
/// middle of the largest cluster of different pixels. Returns 0.
int explain_pixel(const ComparisonRequest& contest, std::string pixel);

}  // namespace rt
