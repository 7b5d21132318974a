// Why a picture shows nothing, and what to try.
#pragma once

#include "common/image.hpp"
#include "common/look.hpp"
#include "common/scene.hpp"

#include <string>

namespace rt {

/// One sentence, if all pixels of the picture that the stage made have one color; else nothing.
/// What it says to try has been tried with a few rays. The scene's first camera is the picture's.
[[nodiscard]] std::string why_blank(const Scene& scene, const Look& look, int stage,
                                    const Image& image);

}  // namespace rt
