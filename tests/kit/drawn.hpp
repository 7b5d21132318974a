// Pictures, as the stage's program draws them.
#pragma once

#include "common/image.hpp"
#include "common/look.hpp"
#include "common/scene.hpp"

namespace rt {

/// The scene through its first camera; of a picture that takes seconds, every so many-th pixel of
/// every so many-th row, the others black. Where a suite asks another process (tests/contract), the
/// picture is drawn there.
[[nodiscard]] Image drawn(const Scene& scene, const Look& look = {}, int every = 1);

}  // namespace rt
