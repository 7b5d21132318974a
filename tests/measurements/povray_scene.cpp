// Scenes as POV-Ray 3.7 reads them.
#include "common/explain/text.hpp"

#include "steps/step02_camera_basis/camera_basis.hpp"

#include "tests/measurements/peer_scenes.hpp"

#include <cmath>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>

namespace measurements {

namespace {

using namespace rt;

class Writer {
public:
    Writer(std::ostream& out, const Scene& scene, const Effort& effort)
        : out_(out), scene_(scene), effort_(effort) {}

    void write() const {
        // A level is a ray, the eye's too. 1/512 is where Raysteps stops as well.
        out_ << "#version 3.7;\nglobal_settings { assumed_gamma 1 max_trace_level "
             << effort_.depth + 1 << " adc_bailout 1/512 ambient_light rgb "
             << vector(scene_.ambient ? scene_.ambient->ratio * scene_.ambient->color : Color(0))
             << " }\n";
        write_camera();
        for (const Light& light : scene_.lights) write_light(light);
        write_shapes();
        for (const auto& [mesh, material] : scene_.meshes) write_mesh(mesh, material);
    }

private:
    static std::string vector(Vec3 v) {
        return "<" + text(v.x) + "," + text(v.y) + "," + text(v.z) + ">";
    }

    /// With a float's digits: a mesh has no more, and reading them would be timed.
    static std::string short_vector(Vec3 v) {
        return "<" + f32_text(v.x) + "," + f32_text(v.y) + "," + f32_text(v.z) + ">";
    }

    void write_camera() const {
        const auto& [width, height] = scene_.resolution;
        const Camera& camera = scene_.cameras.front();
        const auto& [x, y, z] = camera_basis(camera.direction);
        const Real half_height = std::tan(vertical_fov(camera, scene_.resolution) / 2);
        out_ << "camera { location " << vector(camera.position) << " direction " << vector(-z)
             << " up " << vector(2 * half_height * y) << " right "
             << vector(2 * half_height * width / height * x) << " }\n";
    }

    void write_light(const Light& light) const {
        out_ << "light_source { " << vector(light.position) << " rgb "
             << vector(light.brightness * light.color);
        if (light.radius > 0) {
            const auto side = int(std::lround(std::sqrt(effort_.shadow_samples)));
            out_ << " area_light " << 2 * light.radius << "*x, " << 2 * light.radius << "*y, "
                 << side << ", " << side << " jitter circular orient";
        }
        out_ << " }\n";
    }

    void write_texture(const Material& material) const {
        const Real own = 1 - material.mirror;
        out_ << " texture { pigment { rgb " << vector(material.color) << " } finish { ambient "
             << own << " diffuse " << own << " phong " << own * material.specular << " phong_size "
             << material.shininess << " reflection { " << material.mirror << " } } } }\n";
    }

    /// Each kind of shape, by the keyword of its line.
    void write_shapes() const {
        for (const auto& [sphere, material] : scene_.spheres) {
            out_ << "sphere { " << vector(sphere.center) << ", " << sphere.radius;
            write_texture(material);
        }
        for (const auto& [plane, material] : scene_.planes) {
            out_ << "plane { " << vector(plane.normal) << ", " << dot(plane.point, plane.normal);
            write_texture(material);
        }
        for (const auto& [triangle, material] : scene_.triangles) {
            out_ << "triangle { " << vector(triangle.a) << ", " << vector(triangle.b) << ", "
                 << vector(triangle.c);
            write_texture(material);
        }
        for (const auto& [square, material] : scene_.squares) {
            const Vec3 x = square.side / 2 * square.basis.x;
            const Vec3 y = square.side / 2 * square.basis.y;
            out_ << "polygon { 5";
            for (const Vec3& corner : {-x - y, x - y, x + y, y - x, -x - y})
                out_ << ", " << vector(square.center + corner);
            write_texture(material);
        }
        for (const auto& [cylinder, material] : scene_.cylinders) {
            const Vec3 end = cylinder.height / 2 * cylinder.axis;
            out_ << "cylinder { " << vector(cylinder.center - end) << ", "
                 << vector(cylinder.center + end) << ", " << cylinder.radius << " open";
            write_texture(material);
        }
        for (const auto& [cone, material] : scene_.cones) {
            out_ << "cone { " << vector(cone.apex) << ", 0, "
                 << vector(cone.apex + cone.height * cone.axis) << ", " << cone.radius << " open";
            write_texture(material);
        }
        for (const auto& [box, material] : scene_.boxes) {
            const auto& [x, y, z] = box.basis;
            out_ << "box { " << vector(-box.half_size) << ", " << vector(box.half_size)
                 << " matrix <";
            for (const Vec3& row : {x, y, z}) out_ << row.x << "," << row.y << "," << row.z << ",";
            out_ << box.center.x << "," << box.center.y << "," << box.center.z << ">";
            write_texture(material);
        }
    }

    /// The items of a list in POV-Ray's format: the count, then each item.
    template <class List, class ToVector>
    void write_list(std::string_view name, const List& list, ToVector to_vector) const {
        out_ << name << " { " << list.size();
        for (const auto& item : list) out_ << ",\n" << to_vector(item);
        out_ << " }\n";
    }

    void write_mesh(const MeshInstance& instance, const Material& material) const {
        const Mesh& mesh = instance.model->mesh;
        out_ << "mesh2 { ";
        write_list("vertex_vectors", mesh.vertices, [&](Vec3 vertex) {
            return short_vector(transformed(vertex, instance.placement));
        });
        if (!mesh.normals.empty())
            write_list("normal_vectors", mesh.normals, [&](Vec3 normal) {
                return short_vector(rotated(normal, instance.placement));
            });
        write_list("face_indices", mesh.triangles, [](const auto& corners) {
            return "<" + std::to_string(corners[0]) + "," + std::to_string(corners[1]) + "," +
                   std::to_string(corners[2]) + ">";
        });
        write_texture(material);
    }

    std::ostream& out_;
    const Scene& scene_;
    Effort effort_;
};

}  // namespace

void write_povray(std::ostream& out, const Scene& scene, const Effort& effort) {
    out.precision(std::numeric_limits<Real>::max_digits10);
    Writer(out, scene, effort).write();
}

}  // namespace measurements
