// Whole pictures in a page: C functions around the scene that was read last.
#pragma once

#include <cstddef>

extern "C" {

/// A buffer of this size, to be filled with a scene, or with the name and then the content of a
/// mesh's file.
char* picture_room(std::size_t size);

/// The last result.
const char* picture_result();

/// Stores the mesh's file that is in the buffer, whose name has this size, for scenes that name it.
void picture_mesh(std::size_t name_size);

/// Reads the scene in the buffer for the program of a stage. The result are the warnings; returns
/// its size.
std::size_t picture_read(int stage);

/// The height of a picture of this width, with the sides of the scene's R.
int picture_height(int width);

/// Renders the picture: the result has red, green, blue and 255 of each pixel. Returns its size.
std::size_t picture_draw(int width);

/// The line of the scene's camera after turns in degrees: to the right, up, and on its way around
/// the middle of the shapes. Returns its size.
std::size_t picture_camera(double right, double up, double around);
}
