// The meshes that a scene names.
#pragma once

#include "common/scene.hpp"

namespace rt {

/// Loads the scene's named meshes, each file once, and places them. Throws InputError for a file
/// that is wrong; that and each warning say which line of the scene names it. Only a program of a
/// stage with meshes has it: without_meshes.cpp takes its place in the others, which need no
/// OpenMesh then.
void load_meshes(Scene& scene, const Warn& warn = nullptr);

}  // namespace rt
