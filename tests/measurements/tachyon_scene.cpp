// Scenes as Tachyon 0.99 reads them.
#include "common/explain/text.hpp"
#include "common/system/input_error.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/peer_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <ostream>
#include <vector>

namespace measurements {

namespace {

using namespace rt;

/// Tachyon's x axis is mirrored relative to Raysteps': z is negated, so that both render the same
/// picture.
std::string vector(Vec3 v) {
    return text(v.x) + " " + text(v.y) + " " + text(-v.z);
}

/// With a float's digits: a mesh has no more, and reading them would be timed.
std::string short_vector(Vec3 v) {
    return f32_text(v.x) + " " + f32_text(v.y) + " " + f32_text(-v.z);
}

class Writer {
public:
    Writer(std::ostream& out, const Scene& scene, const Effort& effort)
        : out_(out), scene_(scene), effort_(effort) {}

    void write() {
        const auto& [width, height] = scene_.resolution;
        out_ << "BEGIN_SCENE\nRESOLUTION " << width << " " << height << "\n";
        write_camera();
        for (const Light& light : scene_.lights) write_light(light);
        write_shapes();
        for (const auto& [mesh, material] : scene_.meshes) write_mesh(mesh, texture(material));
        out_ << "END_SCENE\n";
    }

private:
    void write_camera() const {
        const Camera& camera = scene_.cameras.front();
        const Basis basis = camera_basis(camera.direction);
        out_ << "CAMERA ZOOM " << 0.5 / std::tan(vertical_fov(camera, scene_.resolution) / 2)
             << " ASPECTRATIO 1 ANTIALIASING 0 RAYDEPTH " << effort_.depth + 1 << " CENTER "
             << vector(camera.position) << " VIEWDIR " << vector(-basis.z) << " UPDIR "
             << vector(basis.y) << " END_CAMERA\nBACKGROUND 0 0 0\n";
    }

    void write_light(const Light& light) const {
        const Color color = light.brightness * light.color;
        const int points = light.radius > 0 ? effort_.shadow_samples : 1;
        for (int i = 0; i < points; ++i) {
            // Spread over the level disc, each point's share of it the same (Vogel 1979).
            const Real radius = light.radius * std::sqrt((i + 0.5) / points);
            const Real turn = i * pi * (3 - std::sqrt(5.0));
            const Vec3 off(radius * std::cos(turn), 0, radius * std::sin(turn));
            out_ << "LIGHT CENTER " << vector(light.position + (points > 1 ? off : Vec3(0)))
                 << " RAD 0.0001 COLOR " << color.r / points << " " << color.g / points << " "
                 << color.b / points << "\n";
        }
    }

    /// The name of the material's texture, which is written before its first use.
    std::string texture(const Material& m) {
        const auto same = [&m](const Material& other) {
            return other.color == m.color && other.specular == m.specular &&
                   other.shininess == m.shininess && other.mirror == m.mirror;
        };
        const auto known = std::find_if(materials_.begin(), materials_.end(), same);
        const std::string name = "m" + std::to_string(known - materials_.begin());
        if (known != materials_.end()) return name;
        materials_.push_back(m);
        const Real own = 1 - m.mirror;
        const Real ambient = scene_.ambient ? scene_.ambient->ratio : 0;
        out_ << "TEXDEF " << name << " AMBIENT " << own * ambient << " DIFFUSE " << own
             << " SPECULAR " << m.mirror << " OPACITY 1 PHONG PLASTIC " << own * m.specular
             << " PHONG_SIZE " << m.shininess << " COLOR " << m.color.r << " " << m.color.g << " "
             << m.color.b << " TEXFUNC 0\n";
        return name;
    }

    void write_triangle(Vec3 a, Vec3 b, Vec3 c, const std::string& texture) const {
        out_ << "TRI V0 " << vector(a) << " V1 " << vector(b) << " V2 " << vector(c) << " "
             << texture << "\n";
    }

    void write_shapes() {
        if (!scene_.cones.empty()) throw InputError({}, "Tachyon has no cones");
        if (!scene_.boxes.empty()) throw InputError({}, "Tachyon has no turned boxes");
        for (const auto& [sphere, material] : scene_.spheres) {
            const std::string name = texture(material);
            out_ << "SPHERE CENTER " << vector(sphere.center) << " RAD " << sphere.radius << " "
                 << name << "\n";
        }
        for (const auto& [plane, material] : scene_.planes) {
            const std::string name = texture(material);
            out_ << "PLANE CENTER " << vector(plane.point) << " NORMAL " << vector(plane.normal)
                 << " " << name << "\n";
        }
        for (const auto& [triangle, material] : scene_.triangles)
            write_triangle(triangle.a, triangle.b, triangle.c, texture(material));
        for (const auto& [square, material] : scene_.squares) {
            const std::string name = texture(material);
            const Vec3 x = square.side / 2 * square.basis.x;
            const Vec3 y = square.side / 2 * square.basis.y;
            const Vec3& c = square.center;
            write_triangle(c - x - y, c + x - y, c + x + y, name);
            write_triangle(c - x - y, c + x + y, c - x + y, name);
        }
        for (const auto& [cylinder, material] : scene_.cylinders) {
            const std::string name = texture(material);
            const Vec3 end = cylinder.height / 2 * cylinder.axis;
            out_ << "FCYLINDER BASE " << vector(cylinder.center - end) << " APEX "
                 << vector(cylinder.center + end) << " RAD " << cylinder.radius << " " << name
                 << "\n";
        }
    }

    void write_mesh(const MeshInstance& instance, const std::string& texture) const {
        const Mesh& mesh = instance.model->mesh;
        for (const auto& corners : mesh.triangles) {
            out_ << (mesh.normals.empty() ? "TRI" : "STRI");
            for (std::size_t i = 0; i < 3; ++i)
                out_ << " V" << i << " "
                     << short_vector(transformed(mesh.vertices[corners[i]], instance.placement));
            for (std::size_t i = 0; i < 3 && !mesh.normals.empty(); ++i)
                out_ << " N" << i << " "
                     << short_vector(rotated(mesh.normals[corners[i]], instance.placement));
            out_ << " " << texture << "\n";
        }
    }

    std::ostream& out_;
    const Scene& scene_;
    Effort effort_;
    std::vector<Material> materials_;
};

}  // namespace

void write_tachyon(std::ostream& out, const Scene& scene, const Effort& effort) {
    out.precision(std::numeric_limits<Real>::max_digits10);
    Writer(out, scene, effort).write();
}

}  // namespace measurements
