#include "common/mesh_file/ply_header.hpp"

#include "common/system/escaping.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <array>

namespace rt {

namespace {

constexpr std::array<PlyType, 16> types = {{{"char", 1},
                                            {"int8", 1},
                                            {"uchar", 1, false, false},
                                            {"uint8", 1, false, false},
                                            {"short", 2},
                                            {"int16", 2},
                                            {"ushort", 2, false, false},
                                            {"uint16", 2, false, false},
                                            {"int", 4},
                                            {"int32", 4},
                                            {"uint", 4, false, false},
                                            {"uint32", 4, false, false},
                                            {"float", 4, true},
                                            {"float32", 4, true},
                                            {"double", 8, true},
                                            {"float64", 8, true}}};

PlyType take_type(std::string_view& line, const MeshLines& lines) {
    const std::string_view word = take_word(line);
    const auto type = std::ranges::find(types, word, &PlyType::name);
    if (type == types.end())
        lines.refuse("expected the type of a property, such as float, not " + quoted(word));
    return *type;
}

PlyProperty take_property(std::string_view line, const MeshLines& lines) {
    PlyProperty property;
    std::string_view after_list = line;
    if (take_word(after_list) == "list") {
        property.length = take_type(after_list, lines);
        line = after_list;
    }
    property.type = take_type(line, lines);
    property.name = lower_case(std::string(take_word(line)));
    property.line = lines.number();
    if (property.name.empty()) lines.refuse("expected the name of a property after its type");
    return property;
}

PlyElement take_element(std::string_view line, const MeshLines& lines) {
    PlyElement element = {.name = std::string(take_word(line)), .line = lines.number()};
    const std::string_view word = take_word(line);
    const auto count = whole_number(word);
    if (!count || *count < 0) lines.refuse("expected the number of elements, not " + quoted(word));
    element.count = static_cast<std::uint64_t>(*count);
    return element;
}

}  // namespace

PlyHeader take_ply_header(MeshLines& lines) {
    std::string_view rest = lines.next().value_or("");
    if (const auto word = take_word(rest); word != "ply" && word != "PLY")
        lines.refuse("expected ply, not " + quoted(word));
    PlyHeader header;
    while (const auto line = lines.next()) {
        rest = *line;
        const std::string_view keyword = take_word(rest);
        if (keyword == "end_header") return header;
        if (keyword == "format") {
            header.format = take_word(rest);
            const std::string_view version = take_word(rest);
            if (version != "1.0") lines.refuse("expected version 1.0, not " + quoted(version));
        } else if (keyword == "element") {
            header.elements.push_back(take_element(rest, lines));
        } else if (keyword == "property" && !header.elements.empty()) {
            header.elements.back().properties.push_back(take_property(rest, lines));
        } else if (keyword != "comment" && keyword != "obj_info") {
            lines.refuse("expected format, element, property or end_header, not " +
                         quoted(keyword));
        }
    }
    lines.refuse("the file ends before its end_header");
}

namespace {

std::ptrdiff_t count_of(const PlyElement& element, std::string_view property) {
    return std::ranges::count(element.properties, property, &PlyProperty::name);
}

void check_vertex(const PlyElement& vertex, const std::string& file) {
    for (const std::string_view name : ply_coordinates) {
        const std::ptrdiff_t count = count_of(vertex, name);
        if (count == 1 || (count == 0 && name[0] == 'n')) continue;
        throw InputError({file, vertex.line}, "a vertex has " + std::to_string(count) +
                                                  " properties " + std::string(name) +
                                                  ": expected one");
    }
    for (const PlyProperty& p : vertex.properties) {
        if (!p.length || std::ranges::find(ply_coordinates, p.name) == ply_coordinates.end())
            continue;
        throw InputError({file, p.line}, "a vertex's " + p.name + " is a list: expected a number");
    }
}

/// Checks an element of faces or of strips.
void check_corners(const PlyElement& face, const std::string& file) {
    const std::ptrdiff_t count = std::ranges::count_if(face.properties, is_corners);
    if (count != 1) {
        std::string others;
        for (const PlyProperty& p : face.properties)
            if (p.length && !is_corners(p))
                others += (others.empty() ? "" : ", ") + rt::quoted(p.name);
        throw InputError(
            {file, face.line},
            "a " + face.name + " has " + std::to_string(count) + " lists vertex_indices" +
                (others.empty() ? "" : ", and the lists " + others) + ": expected one");
    }
    const PlyProperty& corners = *std::ranges::find_if(face.properties, is_corners);
    if (corners.length && !corners.type.is_float) return;
    throw InputError({file, corners.line},
                     rt::quoted(corners.name) + " must be a list of whole numbers");
}

}  // namespace

std::string items_of(const PlyElement& element) {
    if (element.name == "vertex") return "vertices";
    if (element.name == "face") return "faces";
    return "items of " + rt::quoted(element.name);
}

void name_corners(PlyHeader& header, MeshBuilder& builder) {
    for (PlyElement& element : header.elements) {
        if (!has_faces(element) || std::ranges::any_of(element.properties, is_corners)) continue;
        const auto may_be_corners = [](const PlyProperty& p) {
            return p.length && !p.length->is_float && !p.type.is_float;
        };
        if (std::ranges::count_if(element.properties, may_be_corners) != 1) continue;
        PlyProperty& corners = *std::ranges::find_if(element.properties, may_be_corners);
        builder.warn("the list " + rt::quoted(corners.name) + " is read as vertex_indices",
                     corners.line);
        corners.name = "vertex_indices";
    }
}

void check_ply_header(const PlyHeader& header, const std::string& file) {
    if (header.format != "ascii" && header.format != "binary_little_endian" &&
        header.format != "binary_big_endian") {
        throw InputError({file},
                         "expected the format ascii, binary_little_endian or binary_big_endian, "
                         "not " +
                             rt::quoted(header.format));
    }
    const auto& elements = header.elements;
    const auto vertices = std::ranges::count(elements, "vertex", &PlyElement::name);
    if (vertices != 1)
        throw InputError({file},
                         "has " + std::to_string(vertices) + " elements vertex: expected one");
    if (std::ranges::none_of(elements, has_faces))
        throw InputError({file}, "has no element face, and so no surface: points cannot be drawn");
    for (const PlyElement& element : elements) {
        for (const PlyProperty& p : element.properties) {
            if (!p.length || !p.length->is_float) continue;
            throw InputError({file, p.line},
                             "the length of the list " + rt::quoted(p.name) +
                                 " must be a whole number, as uchar or int, not a " +
                                 std::string(p.length->name));
        }
        if (element.name == "vertex") check_vertex(element, file);
        if (has_faces(element)) check_corners(element, file);
    }
}

void check_ply_size(const PlyHeader& header, std::uint64_t bytes, const std::string& file) {
    for (const PlyElement& element : header.elements) {
        std::uint64_t least = 0;
        for (const PlyProperty& p : element.properties)
            least += p.length ? p.length->size : p.type.size;
        if (least == 0) continue;
        if (element.count > bytes / least)
            throw InputError({file, element.line}, "the file ends too early for " +
                                                       std::to_string(element.count) + " " +
                                                       items_of(element));
        bytes -= element.count * least;
    }
}

}  // namespace rt
