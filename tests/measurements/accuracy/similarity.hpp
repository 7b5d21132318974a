// How alike two pictures look.
#pragma once

#include "common/image/image.hpp"

namespace rt {

/// The structural similarity of two pictures of the same size, 11 pixels or more on a side: the
/// mean over the three channels and over all windows that lie in the picture; 1 for equal pictures.
/// Wang, Bovik, Sheikh and Simoncelli, "Image quality assessment: from error visibility to
/// structural similarity", 2004, with their window and constants.
[[nodiscard]] double structural_similarity(const Image& a, const Image& b);

}  // namespace rt
