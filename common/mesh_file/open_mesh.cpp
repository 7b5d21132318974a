#include "common/mesh_file/open_mesh.hpp"

#include "common/system/input_error.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>

#include <sstream>
#include <string_view>
#include <utility>

namespace rt {

namespace {

/// Disables OpenMesh's messages on the terminal; the program reports a single error instead.
void silence_open_mesh() {
    omerr().disable();
    omlog().disable();
    omout().disable();
}

}  // namespace

void read_checked(CheckedMesh mesh, const std::string& file, MeshImporter& importer) {
    silence_open_mesh();
    std::istringstream stream(std::move(mesh.content), std::ios::in | std::ios::binary);
    // The PLY reader does not check whether it has read a number. The others read line by line
    // until the end, and misread nothing after the checks.
    if (mesh.reader == std::string_view("ply"))
        stream.exceptions(std::ios::failbit | std::ios::badbit);
    OpenMesh::IO::Options options = OpenMesh::IO::Options::VertexNormal;
    if (mesh.is_binary) options += OpenMesh::IO::Options::Binary;
    try {
        const bool is_read = OpenMesh::IO::IOManager().read(stream, mesh.reader, importer, options);
        if (!is_read) throw InputError({file}, "is not a mesh that OpenMesh can read");
    } catch (const std::ios_base::failure&) {
        throw InputError({file}, "the file ends too early");
    }
}

}  // namespace rt
