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
// What is NaN is not positive.
#pragma once

#include "common/scene.hpp"
#include "common/surface.hpp"

namespace rt {

/// The unit direction in which light that comes from the unit direction to_light leaves a mirror:
/// 2 ⟨L, N⟩ N − L.
[[nodiscard]] Vec3 reflected(Vec3 to_light, Vec3 normal);

/// What the surface shows of the light that is everywhere: once, however many lights there are.
[[nodiscard]] Color ambient_term(const Surface& surface, const Ambient& ambient);

/// What the surface shows of the light evenly in all directions: by ⟨L, N⟩, and nothing where that
/// is not positive, or where the light stands at the point itself.
[[nodiscard]] Color diffuse_term(const Surface& surface, const Light& light);

/// The highlight: by ⟨R, V⟩ to the power of the shininess; nothing where ⟨L, N⟩ or ⟨R, V⟩ is not
/// positive, or where the light stands at the point itself.
[[nodiscard]] Color specular_term(const Surface& surface, const Light& light);

}  // namespace rt
