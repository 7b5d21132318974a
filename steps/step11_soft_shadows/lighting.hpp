// Light and shadow, from here on.
#pragma once

#include "common/scene.hpp"
#include "common/surface.hpp"

#include "steps/step10_shadows/shadows.hpp"

namespace rt {

/// Whether any shape that the stage knows stands in the way. Its main.cpp defines it.
[[nodiscard]] bool blocked(const Scene& scene, const ShadowRay& way, Context& context);

/// What all the lights do at the surface, which is the bounce-th that the eye's ray has come to. A
/// light with a size is asked for by several rays, until --shadow-samples or --tolerance is
/// reached.
[[nodiscard]] Terms lighting(const Scene& scene, const Surface& surface, std::uint32_t bounce,
                             Context& context);

}  // namespace rt
