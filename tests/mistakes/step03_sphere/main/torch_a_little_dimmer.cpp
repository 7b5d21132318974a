// origin: invented: 254 of 255 levels
// caught by: the torch lights the closest sphere, at the point that is seen (M1)
// sentence: Your colors are a little too dark, by less than one level of 255. The color is that of the sphere times the torch, without another factor.
#include "steps/step03_sphere/sphere.hpp"

#define torch(...) (Real(254) / 255 * torch(__VA_ARGS__))
#include "steps/step03_sphere/main.cpp"
