#include "common/scene_reader.hpp"

#include "common/input_file.hpp"
#include "common/scene_elements.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace rt::inline RT_PRECISION {

namespace {

/// The largest scene known has 11,302 elements, less than 1 MB; this is room for 250,000 of 64
/// bytes. A larger file is something else, and reading on would only fill the memory.
constexpr std::size_t largest_file = std::size_t(16) << 20;

/// No element needs more than a few hundred characters, and a word costs more memory than it has
/// in the file: this bounds what one line can take.
constexpr std::size_t longest_line = 10'000;

void check_is_text(std::string_view text, const SceneReport& report) {
    if (text.size() > largest_file) report.fail(0, 0, "larger than 16 MiB: expected a scene");
    for (int number = 1; !text.empty(); ++number) {
        const std::string_view line = text.substr(0, text.find('\n'));
        const std::size_t zero = line.find('\0');
        if (zero != std::string_view::npos) {
            report.fail(number, static_cast<int>(zero) + 1, "a zero byte: expected text");
        }
        if (line.size() > longest_line) {
            report.fail(number, static_cast<int>(longest_line) + 1,
                        "a line of more than 10000 bytes: expected an element");
        }
        text.remove_prefix(std::min(line.size() + 1, text.size()));
    }
}

std::string all_keywords() {
    std::string list;
    for (const Element& element : elements()) {
        list.append(list.empty() ? "" : " ").append(element.form.keyword);
    }
    return list;
}

/// Sets what one word of "# rt: …" says.
void apply_directive(Token word, int line, SceneReport& report, SceneReading& reading) {
    const std::string_view text = word.text;
    if (text == "fov=vertical" || text == "fov=horizontal") {
        reading.fov_axis = text == "fov=vertical" ? FovAxis::vertical : FovAxis::horizontal;
    } else if (text == "cyl=center" || text == "cyl=base") {
        reading.cylinder_from_base = text == "cyl=base";
    } else {
        report.doubt(line, word.column, "directive " + std::string(text),
                     quoted(text) +
                         " after \"# rt:\" must be fov=vertical, fov=horizontal, "
                         "cyl=center or cyl=base",
                     "it is ignored");
    }
}

/// The reading, with what the file says about itself: on any line, for the whole file.
SceneReading with_directives(std::string_view text, SceneReading reading, SceneReport& report) {
    Lines lines(text);
    while (const auto line = lines.next()) {
        for (const Token word : line->directives) {
            apply_directive(word, line->number, report, reading);
        }
    }
    return reading;
}

/// Reads one file's elements, remembering where each keyword stood first.
class ElementReader {
public:
    ElementReader(ElementReading reading, SceneReport& report)
        : reading_(std::move(reading)), report_(report) {}

    void read(Line line) {
        const Token keyword = line.tokens.front();
        const Element* element = find_element(keyword.text);
        if (!element) {
            report_.doubt(line.number, keyword.column, "keyword " + std::string(keyword.text),
                          quoted(keyword.text) + " must be one of " + all_keywords(),
                          "the line is ignored");
            return;
        }
        const Place place{{}, line.number, keyword.column};
        const bool first = first_.emplace(element->form.keyword, place).second;
        if (!first && element->if_repeated) {
            report_.doubt(line.number, keyword.column, "again " + std::string(keyword.text),
                          "a second " + quoted(keyword.text) + ": expected one",
                          element->if_repeated);
        }
        Fields fields(std::move(line), element->form, report_);
        element->read(fields, reading_, scene_);
        fields.finish();
    }

    /// The scene, after the last line.
    Scene take() {
        if (scene_.cameras.empty()) {
            report_.fail(0, 0, "no camera: expected a line \"C position direction fov\"");
        }
        const auto camera = first_.find("c");
        if (report_.strict() && camera != first_.end() && !first_.contains("R")) {
            report_.fail(camera->second.line, camera->second.column,
                         "\"c\" without a resolution: expected \"R width height\"");
        }
        return std::move(scene_);
    }

private:
    ElementReading reading_;
    SceneReport& report_;
    std::map<std::string_view, Place> first_;
    Scene scene_;
};

}  // namespace

Scene parse_scene(std::string_view text, const std::string& file, BasisAround* basis,
                  const SceneReading& reading) {
    SceneReport report(file, reading);
    check_is_text(text, report);
    ElementReader reader({with_directives(text, reading, report), basis}, report);
    Lines lines(text);
    while (auto line = lines.next()) {
        if (!line->tokens.empty()) reader.read(std::move(*line));
    }
    return reader.take();
}

Scene load_scene(const std::string& file, BasisAround* basis, const SceneReading& reading) {
    return parse_scene(read_input_file(file, largest_file), file, basis, reading);
}

}  // namespace rt::inline RT_PRECISION
