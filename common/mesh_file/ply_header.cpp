#include "common/mesh_file/ply_header.hpp"

#include "common/system/escaping.hpp"
#include "common/system/lower_case.hpp"

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
    const auto type = std::find_if(types.begin(), types.end(),
                                   [=](const PlyType& known) { return known.name == word; });
    if (type == types.end()) {
        lines.refuse("expected the type of a property, such as float, not " + quoted(word));
    }
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
    if (!count || *count < 0) {
        lines.refuse("expected the number of elements, not " + quoted(word));
    }
    element.count = static_cast<std::uint64_t>(*count);
    return element;
}

}  // namespace

PlyHeader take_ply_header(MeshLines& lines) {
    std::string_view rest = lines.next().value_or("");
    if (const auto word = take_word(rest); word != "ply" && word != "PLY") {
        lines.refuse("expected ply, not " + quoted(word));
    }
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

}  // namespace rt
