// The pictures of all stages in one program.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/scene.hpp"

namespace rt::book {

/// Chooses the stage, 1 to 13, whose picture is rendered from now on.
void choose_stage(int stage);

/// The scene's picture, as the stage's program renders it without options.
[[nodiscard]] Image rendered(const Scene& scene);

}  // namespace rt::book
