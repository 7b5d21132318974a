// origin: invented: fewer samples where they are less visible
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: In the mirror you send fewer shadow rays than context.settings.shadow_samples. Their number does not depend on the reflections.
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#define shadow_samples shadow_samples / (context.bounces > 0 ? 2 : 1)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
