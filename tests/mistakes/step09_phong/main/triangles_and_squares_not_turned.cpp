// origin: invented: the normals of triangles and squares are not turned to the eye
// caught by: the surface is lit on the side of the eye (CR §3.1)
// sentence: You do not turn the normals of triangles and squares. They have two sides as well: shading_point turns every normal to the eye.
#include "tests/mistakes/step09_phong/not_turned.hpp"

#define shading_point(hit, ray) shading_point_but_for(hit, ray, scene.triangles, scene.squares)
#include "tests/alternatives/step09_phong/main/without_a_log.cpp"
