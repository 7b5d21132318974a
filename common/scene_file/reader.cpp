#include "common/scene_file/reader.hpp"

#include "common/scene_file/elements.hpp"
#include "common/system/escaping.hpp"
#include "common/system/input_file.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace rt {
inline namespace RT_PRECISION {

namespace {

constexpr std::size_t mebibyte = std::size_t(1) << 20;

/// The largest known scene has 11,302 elements in less than 1 MB; this limit has room for 250,000
/// elements of 64 bytes. A larger file is not a scene, and would only fill the memory.
constexpr std::size_t largest_file = 16 * mebibyte;

/// No element needs more than a few hundred characters, and a word takes more memory than its text:
/// this limits the memory for one line.
constexpr std::size_t longest_line = 10'000;

void check_is_text(std::string_view text, const SceneReport& report) {
    if (text.size() > largest_file)
        report.fail(
            0, 0,
            "larger than " + std::to_string(largest_file / mebibyte) + " MiB: expected a scene");
    if (is_utf16(text)) report.fail(1, 1, text_in_utf16);
    const char end = line_end(text);
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = text.substr(0, text.find(end));
        const auto zero = std::ranges::find(line, '\0');
        if (zero != line.end()) {
            report.fail(number, static_cast<int>(zero - line.begin()) + 1,
                        "a zero byte: expected text");
        }
        if (line.size() > longest_line) {
            report.fail(number, static_cast<int>(longest_line) + 1,
                        "a line of more than " + std::to_string(longest_line) +
                            " bytes: expected an element");
        }
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
}

std::string all_keywords() {
    return joined(
        elements(), [](const Element& element) { return element.form.keyword; }, " ");
}

/// Applies one word of "# rt: …" to the reading options.
void apply_directive(Token word, int line, SceneReport& report, SceneReading& reading) {
    const std::string_view text = word.text;
    if (text == "fov=vertical" || text == "fov=horizontal") {
        reading.fov_axis = text == "fov=vertical" ? FovAxis::vertical : FovAxis::horizontal;
    } else if (text == "cyl=center" || text == "cyl=base") {
        reading.cylinder_from_base = text == "cyl=base";
    } else if (text == "hand=right" || text == "hand=left") {
        reading.axes.left_handed = text == "hand=left";
    } else if (text == "up=y" || text == "up=z") {
        reading.axes.z_up = text == "up=z";
    } else {
        report.doubt(line, word.column, "directive " + std::string(text),
                     quoted(text) +
                         " after \"# rt:\" must be fov=vertical, fov=horizontal, cyl=center, "
                         "cyl=base, hand=right, hand=left, up=y or up=z",
                     "it is ignored");
    }
}

/// The reading options with the file's directives, which may be on any line and apply to the whole
/// file.
SceneReading with_directives(std::string_view text, SceneReading reading, SceneReport& report) {
    Lines lines(text);
    while (const auto line = lines.next()) {
        for (const Token word : line->directives)
            apply_directive(word, line->number, report, reading);
    }
    return reading;
}

/// The axis in the form of a scene file: "-1,0,0".
std::string text_of(Vec3 axis) {
    const auto digits = [](Real component) { return std::to_string(int(component)); };
    return digits(axis.x) + "," + digits(axis.y) + "," + digits(axis.z);
}

/// The direction along a coordinate axis that is closest to the direction of most shapes, measured
/// to their centers from `from`. (0, 0, −1) if there are none, as in MRT §2.
Vec3 axis_to_most_shapes(const Scene& scene, Vec3 from) {
    std::array<int, 6> near{};
    const auto count = [&](Vec3 center) {
        const Vec3 way = center - from;
        const Vec3 size = glm::abs(way);
        const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        if (size[axis] > 0) ++near[std::size_t(2 * axis + (way[axis] < 0 ? 1 : 0))];
    };
    for_each_kind(scene, [&count]<class Shape>(const PrimitiveList<Shape>& primitives) {
        if constexpr (Bounded<Shape>)
            for (const Primitive<Shape>& primitive : primitives) {
                const auto [min, max] = bounds(primitive.shape);
                count(min / Real(2) + max / Real(2));
            }
    });
    for (const MeshRequest& mesh : scene.mesh_requests) count(mesh.placement.translation);
    std::size_t best = 5;
    for (std::size_t i = 0; i < near.size(); ++i)
        if (near[i] > near[best]) best = i;
    Vec3 axis(0);
    axis[int(best) / 2] = best % 2 == 0 ? Real(1) : Real(-1);
    return axis;
}

/// Returns whether the line begins as one of a scene does: with a keyword, and a number or a
/// triple.
bool is_like_element(const std::vector<Token>& words) {
    const std::string_view keyword = words.front().text;
    if (words.size() < 2 || find_element(keyword) == nullptr) return false;
    const std::string_view field = words[1].text;
    const bool triple = field.find(',') != std::string_view::npos;
    return keyword == "R" || keyword == "A" ? !triple : triple || keyword == "mesh";
}

/// A remark for the error of a file that seems to have another format.
std::string foreign_remark(std::string_view text) {
    int lines = 0;
    int known = 0;
    Lines all(text);
    while (const auto line = all.next()) {
        if (line->tokens.empty()) continue;
        ++lines;
        if (is_like_element(line->tokens)) ++known;
    }
    if (2 * known >= lines) return "";
    return std::to_string(lines - known) + " of " + std::to_string(lines) +
           " lines are none of a scene: is this another format?";
}

/// Throws InputError if the file's name is that of a mesh. The book's engine reads scenes too, and
/// has no std::filesystem.
void refuse_mesh(const std::string& file) {
    const std::string name = file.substr(file.find_last_of("/\\") + 1);
    constexpr std::array<std::string_view, 4> endings = {".off", ".obj", ".ply", ".stl"};
    const std::string ending = lower_case(name.substr(std::min(name.rfind('.'), name.size())));
    if (std::ranges::find(endings, ending) == endings.end()) return;
    const bool has_blanks = name.find_first_of(blanks) != std::string::npos;
    throw InputError({file}, "this is a mesh: name it in a scene, as in \"mesh " +
                                 (has_blanks ? "FILE" : name) + " 0,0,0 1 200,200,200\"");
}

/// Reads the elements of one file, and records the first location of each keyword.
class ElementReader {
public:
    ElementReader(ElementReading reading, SceneReport& report)
        : reading_(std::move(reading)), report_(report) {
        scene_.axes = reading_.axes;
    }

    void read(Line line) {
        const Token keyword = line.tokens.front();
        const Element* element = find_element(keyword.text);
        if (!element) {
            report_.doubt(line.number, keyword.column, "keyword " + std::string(keyword.text),
                          quoted(keyword.text) + " must be one of " + all_keywords(),
                          "the line is ignored");
            return;
        }
        const FileLocation place{{}, line.number, keyword.column};
        const bool first = first_.emplace(element->form.keyword, place).second;
        if (!first && element->if_repeated) {
            report_.doubt(line.number, keyword.column, "again " + std::string(keyword.text),
                          "a second " + quoted(keyword.text) + ": expected one",
                          element->if_repeated);
        }
        const int number = line.number;
        const std::size_t cameras = scene_.cameras.size();
        Fields fields(std::move(line), element->form, report_, reading_.axes);
        element->read(fields, reading_, scene_);
        fields.finish();
        if (scene_.cameras.size() > cameras && scene_.cameras.back().direction == Vec3(0))
            without_direction_.push_back(
                {.camera = cameras, .line = number, .column = place.column});
    }

    /// Returns the scene; call it after the last line.
    Scene take() {
        if (scene_.cameras.empty())
            report_.fail(0, 0, "no camera: expected a line \"C position direction fov\"");
        for (const auto& [index, line, column] : without_direction_) {
            Camera& camera = scene_.cameras[index];
            camera.direction = axis_to_most_shapes(scene_, camera.position);
            report_.warn(line, column, "zero",
                         "a camera's direction is zero: it points along " +
                             text_of(to_its_axes(camera.direction, scene_.axes)) +
                             ", the axis nearest to most shapes");
        }
        const auto camera = first_.find("c");
        if (report_.strict() && camera != first_.end() && !first_.contains("R")) {
            report_.fail(camera->second.line, camera->second.column,
                         "\"c\" without a resolution: expected \"R width height\"");
        }
        return std::move(scene_);
    }

private:
    struct Undirected {
        std::size_t camera;
        int line;
        int column;
    };

    ElementReading reading_;
    SceneReport& report_;
    std::map<std::string_view, FileLocation> first_;
    std::vector<Undirected> without_direction_;
    Scene scene_;
};

Scene read_elements(std::string_view text, const ElementReading& reading, SceneReport& report) {
    ElementReader reader(reading, report);
    Lines lines(text);
    while (auto line = lines.next())
        if (!line->tokens.empty()) reader.read(std::move(*line));
    return reader.take();
}

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file, BasisAround* basis,
                  const SceneReading& reading) {
    std::vector<std::string> warnings;  // which a file of another format would fill a screen with
    SceneReading kept = reading;
    if (reading.warn)
        kept.warn = [&warnings](const std::string& warning) { warnings.push_back(warning); };
    const auto print_warnings = [&] {
        for (const std::string& warning : warnings) reading.warn(warning);
    };
    SceneReport report(file, kept);
    check_is_text(text, report);
    try {
        Scene scene = read_elements(text, {with_directives(text, kept, report), basis}, report);
        print_warnings();
        return scene;
    } catch (const InputError& error) {
        const std::string remark = foreign_remark(text);
        if (!remark.empty()) throw error.with(remark);
        print_warnings();
        throw;
    }
}

Scene load_scene(const std::string& file, BasisAround* basis, const SceneReading& reading) {
    const std::string text = read_input_file(file, largest_file);
    refuse_mesh(file);
    return parse_scene(text, file, basis, reading);
}

}  // namespace RT_PRECISION
}  // namespace rt
