// The floating-point type of all lengths, directions and colors, and the types built from it.
//
// Every file that computes is compiled twice, once with RT_FLOAT defined. A type that contains a
// Real is in `inline namespace RT_PRECISION`, so that both compilations link into one program
// and `--precision` selects one at run time. Functions that only use these types are in plain
// `namespace rt`: their parameter types distinguish the two compilations.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

// <math.h>, and not <cmath> alone: with it abs(x) of a Real is no function of int, with or without
// std::.
#include <math.h>

#include <algorithm>  // of most answers: precompiled with a contract, it halves their compile time
#include <limits>

#ifdef RT_FLOAT
#define RT_PRECISION f32
#else
#define RT_PRECISION f64
#endif

namespace rt {
inline namespace RT_PRECISION {

#ifdef RT_FLOAT
using Real = float;
#else
using Real = double;
#endif

using Vec2 = glm::vec<2, Real>;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat4 = glm::mat<4, 4, Real>;

/// Red, green and blue; displayable from 0 to 1.
using Color = Vec3;

inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
inline constexpr Real pi = Real(3.14159265358979323846264338327950288L);

/// u, the largest relative error of one rounded operation: half an ulp of 1 (Higham 2002, §2.1).
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

}  // namespace RT_PRECISION
}  // namespace rt
