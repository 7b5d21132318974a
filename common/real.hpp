// The number every length, direction and colour is made of, and what is built from it.
//
// Every file that computes is compiled twice, once with RT_FLOAT defined. A type that holds a
// Real lives in `namespace rt::inline RT_PRECISION`, so that both compilations link into one
// program and `--precision` chooses between them when it runs. Code that only uses these types
// stands in plain `namespace rt`: its parameters tell the two compilations apart.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <limits>

#ifdef RT_FLOAT
#define RT_PRECISION f32
#else
#define RT_PRECISION f64
#endif

namespace rt::inline RT_PRECISION {

#ifdef RT_FLOAT
using Real = float;
#else
using Real = double;
#endif

using Vec2 = glm::vec<2, Real>;
using Vec3 = glm::vec<3, Real>;
using Vec4 = glm::vec<4, Real>;
using Mat4 = glm::mat<4, 4, Real>;

/// Red, green and blue, 0 to 1 where a picture can show them.
using Color = Vec3;

inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
inline constexpr Real pi = Real(3.14159265358979323846264338327950288L);

/// u, the largest relative error of one rounded operation: half an ulp of 1 (Higham 2002, §2.1).
inline constexpr Real unit_roundoff = std::numeric_limits<Real>::epsilon() / 2;

}  // namespace rt::inline RT_PRECISION
