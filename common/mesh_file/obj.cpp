#include "common/mesh_file/mesh_formats.hpp"
#include "common/mesh_file/mesh_lines.hpp"
#include "common/system/escaping.hpp"

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace rt {

namespace {

/// A line of an OBJ file that is read: v, vn, f or s.
struct Statement {
    std::string_view keyword;
    std::string_view rest;
};

/// The line without its comment. The # of Microsoft's -1.#IND begins none.
std::string_view without_comment(std::string_view line) {
    std::size_t at = line.find('#');
    while (at != std::string_view::npos && at >= 2 && line.substr(at - 2, 2) == "1.")
        at = line.find('#', at + 1);
    return line.substr(0, at);
}

/// The other statements of an OBJ file, in the order of its specification.
constexpr auto skipped = std::to_array<std::string_view>(
    {"vp",        "vt",       "deg",      "bmat",   "step",   "cstype", "p",
     "l",         "curv",     "curv2",    "surf",   "parm",   "trim",   "hole",
     "scrv",      "sp",       "end",      "con",    "g",      "mg",     "o",
     "bevel",     "c_interp", "d_interp", "lod",    "usemtl", "mtllib", "shadow_obj",
     "trace_obj", "ctech",    "stech",    "maplib", "usemap", "call",   "csh"});

/// The statements of a file.
class Statements {
public:
    explicit Statements(MeshLines& lines) : lines_(lines) {}

    std::optional<Statement> next() {
        while (const auto line = lines_.next()) {
            std::string_view rest = without_comment(*line);
            const std::string_view keyword = take_word(rest);
            if (keyword != "v" && keyword != "vn" && keyword != "f" && keyword != "s") {
                note(keyword);
                continue;
            }
            if (rest.find('\\') != std::string_view::npos) rest = with_continuation(rest);
            return Statement{keyword, rest};
        }
        return std::nullopt;
    }

    /// Throws InputError at the first line that no OBJ file has, if there was one.
    void refuse_foreign(const std::string& file) const {
        if (foreign_line_ == 0) return;
        throw InputError({file, foreign_line_}, "has no face, and OBJ has no statement " +
                                                    quoted(foreign_) + ": expected v, vn or f");
    }

private:
    void note(std::string_view keyword) {
        if (foreign_line_ > 0 || keyword.empty() ||
            std::ranges::find(skipped, keyword) != skipped.end())
            return;
        foreign_ = keyword;
        foreign_line_ = lines_.number();
    }

    /// Appends the next line to a line that ends in a backslash. Of the other statements only their
    /// first line has a known keyword; and a path or a name may end in a backslash.
    std::string_view with_continuation(std::string_view rest) {
        joined_.clear();
        while (true) {
            const std::size_t last = rest.find_last_not_of(" \t\r");
            const bool ends_in_backslash = last != std::string_view::npos && rest[last] == '\\';
            const auto next = ends_in_backslash ? lines_.next_of_any_kind() : std::nullopt;
            if (!next) return joined_.append(rest.substr(0, ends_in_backslash ? last : rest.npos));
            joined_.append(rest.substr(0, last)).append(1, ' ');
            rest = without_comment(*next);
        }
    }

    MeshLines& lines_;
    std::string joined_;
    std::string_view foreign_;  ///< the first keyword that is not of OBJ, and its line
    int foreign_line_ = 0;
};

/// Converts an index, from 1, or negative to count back from the last of `before`, to one from 0;
/// nothing if it is 0, or before the first.
std::optional<std::size_t> from_zero(std::int64_t number, std::size_t before) {
    if (number > 0) return std::size_t(number - 1);
    if (number == 0 || number < -std::int64_t(before)) return std::nullopt;
    return before - std::size_t(-number);
}

/// Reads the faces of a file whose vertices and normals are known.
class Faces {
public:
    Faces(const MeshLines& lines, const std::vector<glm::dvec3>& normals, MeshBuilder& builder)
        : lines_(lines), normals_(normals), builder_(builder), vertices_(builder.vertex_count()) {}

    void count_vertex() { ++vertices_before_; }
    void count_normal() { ++normals_before_; }

    void read(std::string_view line) {
        face_.clear();
        for (auto word = take_word(line); !word.empty(); word = take_word(line))
            face_.push_back(corner(word));
        if (face_.size() > std::size_t(most_corners)) {
            lines_.refuse("a face of " + std::to_string(face_.size()) +
                          " corners: expected at most " + std::to_string(most_corners));
        }
        builder_.add_face(face_);
    }

    void warn_of_lost_normals() const {
        if (lost_normals_ == 0) return;
        builder_.warn_of_normals(std::to_string(lost_normals_) +
                                 (lost_normals_ == 1 ? " corner names a normal that is"
                                                     : " corners name normals that are") +
                                 " not in the file: computed from the faces");
    }

private:
    /// Reads a corner "vertex", "vertex/texture", "vertex//normal" or "vertex/texture/normal".
    std::uint32_t corner(std::string_view word) {
        const std::size_t first = word.find('/');
        const std::string_view of_vertex = word.substr(0, first);
        const std::int64_t number = whole(of_vertex, "vertex");
        const auto index = from_zero(number, vertices_before_);
        if (!index || *index >= vertices_) {
            lines_.refuse("a corner's vertex must be " +
                          (number == 0 ? "a whole number other than 0"
                           : number < 0
                               ? "one of the " + std::to_string(vertices_before_) + " before it"
                           : vertices_ == 0 ? "in the file, which has none"
                                            : "from 1 to " + std::to_string(vertices_)) +
                          ", not " + quoted(of_vertex));
        }
        const auto vertex = static_cast<std::uint32_t>(*index);
        if (first == std::string_view::npos) return vertex;
        const std::size_t second = word.find('/', first + 1);
        if (second == std::string_view::npos) return vertex;
        const std::string_view of_normal = word.substr(second + 1);
        if (of_normal.empty()) return vertex;
        const auto normal = from_zero(whole(of_normal, "normal"), normals_before_);
        if (normal && *normal < normals_.size())
            return builder_.with_normal(vertex, normals_[*normal]);
        ++lost_normals_;
        return vertex;
    }

    [[nodiscard]] std::int64_t whole(std::string_view word, const char* what) const {
        if (const auto number = whole_number(word)) return *number;
        lines_.refuse(std::string("a corner's ") + what +
                      " must be a whole number other than 0, not " + quoted(word));
    }

    const MeshLines& lines_;
    const std::vector<glm::dvec3>& normals_;
    MeshBuilder& builder_;
    std::size_t vertices_;
    std::size_t vertices_before_ = 0;
    std::size_t normals_before_ = 0;
    std::size_t lost_normals_ = 0;
    std::vector<std::uint32_t> face_;
};

/// Returns whether the value of a statement s switches smoothing off.
bool is_off(std::string_view value) {
    const std::string_view group = take_word(value);
    return group == "off" || group == "0";
}

}  // namespace

void read_obj(std::string& content, const std::string& file, MeshBuilder& builder) {
    plain_text(content);
    // Faces may precede their vertices.
    std::vector<glm::dvec3> normals;
    bool has_face = false;
    MeshLines lines(content, file);
    Statements first(lines);
    while (const auto statement = first.next()) {
        std::string_view rest = statement->rest;
        if (statement->keyword == "v") {
            builder.add_vertex(take_point(rest, "a vertex", lines));
            require_no_word(rest, "a vertex", lines);
        } else if (statement->keyword == "vn") {
            normals.push_back(take_normal(rest, "a normal", lines));
            require_no_word(rest, "a normal", lines);
        } else if (statement->keyword == "f") {
            has_face = true;
        }
    }
    if (!has_face) first.refuse_foreign(file);
    lines = MeshLines(content, file);
    Statements second(lines);
    Faces faces(lines, normals, builder);
    bool is_flat = false;
    bool is_smooth = false;  // a face
    while (const auto statement = second.next()) {
        if (statement->keyword == "s") is_flat = is_off(statement->rest);
        if (statement->keyword == "v") faces.count_vertex();
        if (statement->keyword == "vn") faces.count_normal();
        if (statement->keyword != "f") continue;
        faces.read(statement->rest);
        is_smooth = is_smooth || !is_flat;
    }
    if (!is_smooth) builder.set_crease(0);
    faces.warn_of_lost_normals();
}

}  // namespace rt
