// origin: invented: what shines in a mirror is its reflection
// caught by: what a mirror shows is lit, and in shadow, as if it were seen (CR §5.1)
// sentence: A surface that is partly a mirror has no highlight in your answer. Its own color has all three terms.
#include "steps/step09_phong/phong.hpp"

#define specular_term(surface, light) \
    (surface.material.mirror > 0 ? Color(0) : specular_term(surface, light))
#include "tests/alternatives/step12_mirror/main/own_samples.cpp"
