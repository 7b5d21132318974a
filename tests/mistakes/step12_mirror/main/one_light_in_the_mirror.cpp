// origin: invented: only the first light lights what a mirror shows
// caught by: a mirror shows what another mirror shows (CR §5.1)
// sentence: In the mirror only the first light counts. What a mirror shows has the sum of all lights.
#include "steps/step09_phong/phong.hpp"

#define diffuse_term(surface, light) \
    (context.bounces > 0 && number > 1 ? Color(0) : diffuse_term(surface, light))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
