// origin: invented: black after some reflections
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: After some reflections you return black without a hit. The last mirror shows the sky like the first.
#include "common/render/stage.hpp"

#define background(scene, ray) (context.bounces > 2 ? Color(0) : background(scene, ray))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
