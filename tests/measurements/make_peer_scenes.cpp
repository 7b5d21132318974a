// Makes the scenes on which Raysteps, POV-Ray and Tachyon are compared, or converts any scene for
// the peers:
//
//     make_peer_scenes FOLDER              the eight as .rt, .pov and .dat, and their meshes
//     make_peer_scenes FOLDER scene.rt     that scene as .pov and .dat
#include "common/program/load_meshes.hpp"
#include "common/scene_file/reader.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "scenes/meshes/surfaces.hpp"
#include "scenes/meshes/write_mesh.hpp"
#include "tests/measurements/peer_scenes.hpp"

#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>

namespace {

using namespace measurements;
using std::filesystem::path;

void write(const path& file, const std::function<void(std::ostream&)>& write_content) {
    std::ofstream out(file, std::ios::binary);
    write_content(out);
    out.flush();
    if (!out) throw rt::InputError({file.string()}, "cannot be written");
}

void write_mesh(const path& file, int n) {
    write(file,
          [&](std::ostream& out) { out << rt::mesh_text(rt::hilly_sphere(n), file.string(), 6); });
}

/// The `.rt` file for the others, beside each other in the folder.
void write_for_peers(const path& file, const path& folder, const Effort& effort) {
    rt::Scene scene = rt::load_scene(file.string(), rt::orthonormal_basis);
    rt::load_meshes(scene);
    const path stem = folder / file.stem();
    write(path(stem) += ".pov", [&](std::ostream& out) { write_povray(out, scene, effort); });
    const path for_tachyon = path(stem) += ".dat";
    try {
        write(for_tachyon, [&](std::ostream& out) { write_tachyon(out, scene, effort); });
    } catch (const rt::InputError& error) {
        std::filesystem::remove(for_tachyon);
        std::cerr << file.string() << ": not for Tachyon: " << error.what() << '\n';
    }
}

void make_all(const path& folder) {
    std::filesystem::create_directories(folder);
    write_mesh(folder / "sphere_70k.off", 59);
    write_mesh(folder / "sphere_1m.off", 224);
    for (const PeerScene& scene : peer_scenes()) {
        const path file = folder / (scene.name + ".rt");
        write(file, [&](std::ostream& out) {
            out << "R " << scene.size.width << " " << scene.size.height << "\n" << scene.text();
        });
        write_for_peers(file, folder, scene.effort);
    }
}

}  // namespace

int main(int count, char** words) {
    try {
        if (count == 2 && words[1][0] != '-') {
            make_all(words[1]);
        } else if (count == 3) {
            write_for_peers(words[2], words[1], {});
        } else {
            throw rt::InputError({}, "expected make_peer_scenes FOLDER [SCENE]");
        }
        return 0;
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
