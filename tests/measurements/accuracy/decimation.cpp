// The owl of stage 13 with fewer and fewer triangles (OpenMesh, by quadrics: Garland and Heckbert
// 1997): how many pixels are others, and how long the picture takes.
#include "tests/measurements/accuracy/drawing.hpp"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <random>
#include <stdexcept>
#include <string>

using namespace rt;

namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;
namespace fs = std::filesystem;

constexpr Resolution size{.width = 240, .height = 180};

/// Collapses edges down to this number of triangles, or until none can be collapsed; returns the
/// number left.
std::size_t decimate(Mesh& mesh, std::size_t triangles) {
    OpenMesh::Decimater::DecimaterT<Mesh> decimater(mesh);
    OpenMesh::Decimater::ModQuadricT<Mesh>::Handle quadrics;
    decimater.add(quadrics);
    decimater.module(quadrics).unset_max_err();
    decimater.initialize();
    decimater.decimate_to_faces(0, triangles);
    mesh.garbage_collection();
    return mesh.n_faces();
}

/// A scene of the one mesh, large in the picture, beside its file.
fs::path scene_of(const Mesh& mesh, const fs::path& folder) {
    if (!OpenMesh::IO::write_mesh(mesh, (folder / "owl.off").string()))
        throw std::runtime_error("cannot write " + folder.string());
    std::ofstream(folder / "owl.rt") << "A 0.2 255,255,255\n"
                                        "C 0,1.1,4 0,0,-1 45\n"
                                        "L -3,4,4 0.8 255,255,255\n"
                                        "pl 0,0,0 0,1,0 150,120,90\n"
                                        "mesh owl.off 0,0,0 1 180,140,100\n";
    return folder / "owl.rt";
}

}  // namespace

int main() {
    const std::string number = std::to_string(std::random_device()());
    const fs::path folder = fs::temp_directory_path() / ("raysteps_decimation." + number);
    if (!fs::create_directory(folder)) return 1;  // an existing folder is not touched
    Mesh mesh;
    if (!OpenMesh::IO::read_mesh(mesh, RAYSTEPS_ROOT "/scenes/meshes/owl.off")) return 1;
    const Drawing whole = f64::rendered(scene_of(mesh, folder), size, {});
    std::puts("triangles,seconds,error,seen");
    std::printf("%zu,%.4f,0,0\n", mesh.n_faces(), whole.seconds);
    for (std::size_t wanted = mesh.n_faces() / 2; wanted > 30; wanted /= 2) {
        const std::size_t left = decimate(mesh, wanted);
        if (left > wanted) break;  // further collapses would change the shape
        const Drawing drawing = f64::rendered(scene_of(mesh, folder), size, {});
        const Difference off = difference(drawing.image, whole.image);
        std::printf("%zu,%.4f,%.4g,%.5f\n", left, drawing.seconds, off.error, off.seen);
    }
    fs::remove_all(folder);
}
