// Makes the project's meshes. Those up to a few thousand triangles are in this folder; the large
// ones are made where they are wanted: `make_meshes sphere_1m sphere_1m.off`.

#include "scenes/meshes/owl.hpp"
#include "scenes/meshes/polygons.hpp"
#include "scenes/meshes/surfaces.hpp"
#include "scenes/meshes/write_mesh.hpp"

#include "common/system/input_error.hpp"

#include <exception>
#include <fstream>
#include <iostream>
#include <span>
#include <string_view>

namespace {

using namespace rt;

struct Made {
    std::string_view name;
    std::string_view what;
    Polygons (*make)();
    int decimals = 4;
};

constexpr Made meshes[] = {
    {"cube", "12 triangles, from -1 to 1", cube},
    {"owl_cage", "the owl before it is rounded: quadrilaterals and octagons", owl_cage},
    {"owl", "the owl: 2 x Catmull-Clark, triangles",
     [] { return cut_up(catmull_clark(owl_cage(), 2)); }},
    {"pebble", "1,280 triangles with normals", [] { return with_normals(loop(pebble_cage(), 3)); }},
    {"bowl", "a sheet with one hole", [] { return bowl(40); }},
    {"book", "seven pages on one edge", book},
    {"owl_fine", "the owl, 5 x Catmull-Clark: 532,480 triangles",
     [] { return cut_up(catmull_clark(owl_cage(), 5)); }, 6},
    {"sphere_70k", "a hilly sphere of 69,620 triangles", [] { return hilly_sphere(59); }, 6},
    {"sphere_1m", "a hilly sphere of 1,003,520 triangles", [] { return hilly_sphere(224); }, 6},
};

void list_meshes() {
    for (const Made& made : meshes) {
        std::cout << made.name << std::string(12 - made.name.size(), ' ') << made.what << '\n';
    }
}

void make(std::string_view name, const std::string& output) {
    for (const Made& made : meshes) {
        if (made.name != name) continue;
        const std::string text = mesh_text(made.make(), output, made.decimals);
        std::ofstream stream(output, std::ios::binary);
        stream << text << std::flush;
        if (!stream) throw InputError({output}, "cannot be written");
        return;
    }
    throw InputError(
        {}, "\"" + std::string(name) + "\" is no mesh that is made here: --list says which are");
}

}  // namespace

int main(int count, char** words) {
    try {
        const std::span<char*> arguments(words, static_cast<std::size_t>(count));
        if (count == 2 && arguments[1] == std::string_view("--list")) {
            list_meshes();
        } else if (count == 3) {
            make(arguments[1], arguments[2]);
        } else {
            throw InputError({}, "expected make_meshes NAME OUTPUT, or make_meshes --list");
        }
        return 0;
    } catch (const InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        return 1;
    }
}
