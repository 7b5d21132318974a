// origin: invented: the reflected ray has a context of its own, without the pixel
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: In the mirror all pixels have the same samples: the reflected ray keeps the pixel of its context.
#include "common/render/sampling.hpp"
#include "common/render/stage.hpp"

#define sample_seed(pixel, light, bounce) \
    sample_seed(context.bounces > 0 ? Pixel{} : pixel, light, bounce)
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
