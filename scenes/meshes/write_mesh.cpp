#include "scenes/meshes/write_mesh.hpp"

#include "common/system/input_error.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>

namespace rt {

namespace {

/// Appends numbers, as short as they go.
class Text {
public:
    explicit Text(int decimals) : scale_(std::pow(10.0, decimals)) {}

    Text& operator<<(const char* words) {
        text_ += words;
        return *this;
    }
    Text& operator<<(std::size_t number) {
        text_ += std::to_string(number);
        return *this;
    }
    Text& operator<<(glm::dvec3 v) {
        add(v.x);
        text_ += ' ';
        add(v.y);
        text_ += ' ';
        add(v.z);
        return *this;
    }
    [[nodiscard]] std::string take() { return std::move(text_); }

private:
    /// From whole numbers only, so that no library's way to print a double matters.
    void add(double value) {
        auto scaled = std::llround(value * scale_);
        if (scaled < 0) text_ += '-';
        scaled = std::abs(scaled);
        const auto scale = std::llround(scale_);
        text_ += std::to_string(scaled / scale);
        if (scaled % scale == 0) return;
        std::string fraction = std::to_string(scale + scaled % scale);
        fraction[0] = '.';
        text_ += fraction.substr(0, fraction.find_last_not_of('0') + 1);
    }

    double scale_;
    std::string text_;
};

std::string off(const Polygons& polygons, Text text) {
    text << "OFF\n" << polygons.vertices.size() << " " << polygons.faces.size() << " 0\n";
    for (const glm::dvec3& v : polygons.vertices) text << v << "\n";
    for (const std::vector<int>& face : polygons.faces) {
        text << face.size();
        for (const int corner : face) text << " " << std::size_t(corner);
        text << "\n";
    }
    return text.take();
}

std::string obj(const Polygons& polygons, Text text) {
    for (const glm::dvec3& v : polygons.vertices) text << "v " << v << "\n";
    for (const std::vector<int>& face : polygons.faces) {
        text << "f";
        for (const int corner : face) text << " " << std::size_t(corner + 1);
        text << "\n";
    }
    return text.take();
}

std::string ply(const Polygons& polygons, Text text) {
    text << "ply\nformat ascii 1.0\nelement vertex " << polygons.vertices.size() << "\n"
         << "property float x\nproperty float y\nproperty float z\n";
    const bool has_normals = !polygons.normals.empty();
    if (has_normals) text << "property float nx\nproperty float ny\nproperty float nz\n";
    text << "element face " << polygons.faces.size() << "\n"
         << "property list uchar int vertex_indices\nend_header\n";
    for (std::size_t i = 0; i < polygons.vertices.size(); ++i) {
        text << polygons.vertices[i];
        if (has_normals) text << " " << polygons.normals[i];
        text << "\n";
    }
    for (const std::vector<int>& face : polygons.faces) {
        text << face.size();
        for (const int corner : face) text << " " << std::size_t(corner);
        text << "\n";
    }
    return text.take();
}

std::string stl(const Polygons& polygons, Text text) {
    text << "solid mesh\n";
    for (const std::vector<int>& face : cut_up(polygons).faces) {
        std::array<glm::dvec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = polygons.vertices[static_cast<std::size_t>(face[i])];
        }
        const auto& [a, b, c] = corners;
        text << "facet normal " << glm::normalize(glm::cross(b - a, c - a)) << "\nouter loop\n";
        for (const glm::dvec3& corner : corners) text << "vertex " << corner << "\n";
        text << "endloop\nendfacet\n";
    }
    text << "endsolid mesh\n";
    return text.take();
}

}  // namespace

std::string mesh_text(const Polygons& polygons, const std::string& file, int decimals) {
    const std::string kind = std::filesystem::path(file).extension().string();
    if (kind == ".off") return off(polygons, Text(decimals));
    if (kind == ".obj") return obj(polygons, Text(decimals));
    if (kind == ".ply") return ply(polygons, Text(decimals));
    if (kind == ".stl") return stl(polygons, Text(decimals));
    throw InputError({file}, "expected a name that ends in .off, .obj, .ply or .stl");
}

}  // namespace rt
