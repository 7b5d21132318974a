// Stage 9: light, by Phong's model (CR §3.1; M1's exercise "et pour la position d'une lumière ?").
//
//   CR                          here
//   intersection, normal (N)    surface.point, surface.normal, which is on the side of the eye
//   rayDir (V)                  surface.to_eye
//   L                           the unit direction from the point to light.position
//   reflexion (R)               reflected(L, N)
//   theta, alpha                ⟨L, N⟩ and ⟨R, V⟩, or 0 where they are negative
//   diffuse_material            surface.material.color, and ambient_material too
//   specular_material           surface.material.specular, as white as the light
//   shininess                   surface.material.shininess
//   light.material              light.brightness · light.color, or ambient.ratio · ambient.color
//
// A comparison that requires a positive number is false for NaN.
#pragma once

#include "common/scene/light.hpp"
#include "common/scene/shading_point.hpp"

namespace rt {

/// The unit direction of light reflected by a mirror, 2 ⟨L, N⟩ N − L, for light that arrives from
/// the unit direction to_light.
[[nodiscard]] Vec3 reflected(Vec3 to_light, Vec3 normal);

/// The ambient term: the ambient light that the surface reflects, once for any number of lights.
[[nodiscard]] Color ambient_term(const ShadingPoint& surface, const Ambient& ambient);

/// The diffuse term: light reflected uniformly in all directions, proportional to ⟨L, N⟩. Black
/// where that is not positive, or if the light is at the point itself.
[[nodiscard]] Color diffuse_term(const ShadingPoint& surface, const Light& light);

/// The specular term: the highlight, proportional to ⟨R, V⟩ to the power of the shininess. Black
/// where ⟨L, N⟩ or ⟨R, V⟩ is not positive, or if the light is at the point itself.
[[nodiscard]] Color specular_term(const ShadingPoint& surface, const Light& light);

}  // namespace rt
