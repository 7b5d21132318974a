// origin: invented: the normals of flat shapes are not turned to the eye
// caught by: the terms of all lights add up, from any eye, and --term selects one (CR §3.1)
// sentence: You turn the normals of curved shapes only, as if flat ones had one side. shading_point turns every normal to the eye.
#include "tests/mistakes/step09_phong/not_turned.hpp"

#define shading_point(hit, ray) \
    shading_point_but_for(hit, ray, scene.planes, scene.triangles, scene.squares)
#include "tests/alternatives/step10_shadows/main/without_a_log.cpp"
