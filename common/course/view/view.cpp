#include "common/course/view/view.hpp"

#include "common/course/exercise/log_diff.hpp"
#include "common/course/view/server.hpp"
#include "common/course/view/stage_runner.hpp"
#include "common/course/view/watcher.hpp"
#include "common/image/pixel.hpp"
#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <array>

namespace rt {

namespace {

constexpr int most = 1'000'000'000;  // pages, which call themselves by a number, and their requests
constexpr double farthest = 10'000;  // the largest coordinate of a camera
constexpr int most_shrunk = 16;
constexpr std::size_t longest_report = 4096;
constexpr const char* pixel_error = "4";  // of the picture whose samples are shown

constexpr const char* json_type = "application/json";

/// An option with several values, by number; the first one is the program's default.
void add_choice(Command& options, const Request& request, const std::string& name,
                const std::vector<std::string>& words) {
    const int choice = whole_number(request, name, 0, int(words.size()) - 1);
    if (choice > 0)
        options.insert(options.end(), {"--" + name, words[static_cast<std::size_t>(choice)]});
}

/// Adds the options of what the pixels show. A scale's ends are those of another picture, if they
/// are given.
void add_shade(Command& options, const Request& request) {
    add_choice(options, request, "shade",
               {"", "normal", "depth", "id", "t", "bounces", "cost", "samples"});
    if (!options.empty() && options.back() == "samples")
        options.insert(options.end(), {"--pixel-error", pixel_error});
    if (!request.parameters.contains("low")) return;
    options.insert(options.end(),
                   {"--shade-range", formatted("%.9g,%.9g", number(request, "low", 1e-30, 1e30),
                                               number(request, "high", 1e-30, 1e30))});
}

int parse_stage(const Request& request) {
    return whole_number(request, "stage", 1, int(stage_names.size()));
}

int parse_page(const Request& request) {
    return whole_number(request, "page", 0, most);
}

/// The number of a page's request, in the order in which the page sent them.
int parse_number(const Request& request) {
    return whole_number(request, "order", 1, most);
}

RenderRequest parse_request(const Request& request) {
    RenderRequest picture_request{.stage = parse_stage(request),
                                  .shrink = whole_number(request, "shrink", 1, most_shrunk)};
    if (whole_number(request, "moved", 0, 1) == 1)
        picture_request.camera = {.x = number(request, "x", -farthest, farthest),
                                  .y = number(request, "y", -farthest, farthest),
                                  .z = number(request, "z", -farthest, farthest),
                                  .yaw = number(request, "yaw", -180, 180),
                                  .pitch = number(request, "pitch", -90, 90),
                                  .fov = number(request, "fov", 1, 179)};
    add_choice(picture_request.options, request, "precision", {"double", "float"});
    if (picture_request.stage >= shapes_stage) add_shade(picture_request.options, request);
    if (picture_request.stage >= light_stage)
        add_choice(picture_request.options, request, "term",
                   {"", "ambient", "diffuse", "specular"});
    return picture_request;
}

std::string json_line(const std::optional<std::string>& line) {
    return line ? json(tr_line(*line)) : "null";
}

/// A row is [mine, the reference's, whether they differ].
std::string json_rows(const LogDiff& diff) {
    const auto row_of = [](const LogRow& row) {
        return "[" + json_line(row.mine) + "," + json_line(row.reference) + "," +
               (row.differs ? "true]" : "false]");
    };
    const auto own = [](const std::string& message) { return json(tr_text(message)); };
    return "{\"rows\":[" + joined(diff.rows, row_of, ",") + "],\"first\":" + json(diff.first) +
           ",\"unwritten\":[" + joined(diff.unwritten, own, ",") + "]}";
}

/// The page's questions, answered.
class Viewer {
public:
    explicit Viewer(const ViewSettings& settings) : settings_(settings) {}

    Response answer(const Request& request) {
        const std::string& route = request.path;
        if (route.empty()) return part("page.html", "text/html; charset=utf-8");
        if (route == "page.css") return part(route, "text/css; charset=utf-8");
        if (route == "words") return words();
        if (route == "words.js" || route == "page.js" || route == "difference.js" ||
            route == "rays.js")
            return part(route, "text/javascript; charset=utf-8");
        if (route == "stages") return stages();
        if (route == "news") return news(request);
        if (route == "picture") return picture(request);
        if (route == "story") return log(request);
        if (route == "rays") return rays(request);
        throw Refusal{404, "there is no such page"};
    }

    void stop() {
        for (RenderQueue& turns : pictures_) turns.cancel_all();
        stories_.cancel_all();
        drawings_.cancel_all();
        watcher_.stop();
    }

private:
    /// One of the files of the page.
    [[nodiscard]] Response part(const std::string& name, const std::string& type) const {
        return {.body = read_text(settings_.project / "common/course/view" / name), .type = type};
    }

    /// The catalogue of the page's language, as a script.
    [[nodiscard]] Response words() const {
        const std::string language = settings_.language.empty() ? "en" : settings_.language;
        const std::string all = joined(
            translations_in(settings_.project / "lang" / language / "view.po"),
            [](const CatalogueEntry& entry) { return json(entry.english) + ":" + json(entry.own); },
            ",");
        return {.body = "const language = " + json(language) + ", words = {" + all + "};\n",
                .type = "text/javascript; charset=utf-8"};
    }

    Response stages() const {
        return {.body = "{\"first\":" + std::to_string(settings_.stage) + ",\"stages\":[" +
                        joined(stage_names, json, ",") + "]}",
                .type = json_type};
    }

    [[nodiscard]] std::string started() const {
        std::string list;
        for (int stage = 1; stage <= int(stage_names.size()); ++stage)
            if (!student_files(settings_, stage).empty())
                list += (list.empty() ? "" : ",") + std::to_string(stage);
        return "[" + list + "]";
    }

    Response news(const Request& request) {
        const int stage = parse_stage(request);
        const auto seen = request.parameters.find("seen");
        const StageStatus news = watcher_.wait(
            parse_page(request), stage, seen == request.parameters.end() ? "" : seen->second);
        const SceneView view = scene_view(settings_, stage);
        std::string body = "{\"seen\":" + json(fingerprint(news)) +
                           ",\"programs\":" + json(news.programs) +
                           ",\"building\":" + (news.building ? "true" : "false") +
                           ",\"error\":" + json(news.error) + ",\"started\":" + started() +
                           ",\"width\":" + std::to_string(view.width) +
                           ",\"height\":" + std::to_string(view.height) + ",\"camera\":";
        if (const auto& camera = view.camera)
            body +=
                formatted(R"({"x":%.9g,"y":%.9g,"z":%.9g,"yaw":%.9g,"pitch":%.9g,"fov":%.9g})",
                          camera->x, camera->y, camera->z, camera->yaw, camera->pitch, camera->fov);
        else
            body += "null";
        return {.body = body + "}", .type = json_type};
    }

    Response picture(const Request& request) {
        const RenderRequest picture_request = parse_request(request);
        const int whose = whole_number(request, "whose", 0, 1);
        Picture made;
        const bool finished = pictures_[static_cast<std::size_t>(whose)].take(
            parse_page(request), parse_number(request), [&](const std::atomic<bool>& cancelled) {
                made = runner_.draw(picture_request, Whose(whose), cancelled);
            });
        if (!finished) throw Refusal{409, "another picture was requested"};
        if (made.png.empty()) throw Refusal{422, tr_lines(made.report)};
        return {.body = made.png,
                .type = "image/png",
                .report = tr_lines(made.report).substr(0, longest_report)};
    }

    /// The output of both programs about the requested pixel.
    std::vector<std::string> about_pixel(const Request& request, const std::string& option,
                                         RenderQueue& queue) {
        const RenderRequest picture_request = parse_request(request);
        const int row = whole_number(request, "row", 0, largest_side);
        const int column = whole_number(request, "column", 0, largest_side);
        std::vector<std::string> printed;
        const bool finished = queue.take(
            parse_page(request), parse_number(request), [&](const std::atomic<bool>& cancelled) {
                printed = runner_.about_pixel(picture_request, option, row, column, cancelled);
            });
        if (!finished) throw Refusal{409, "another pixel was requested"};
        return printed;
    }

    Response log(const Request& request) {
        const std::vector<std::string> printed = about_pixel(request, "--pixel", stories_);
        return {.body = json_rows(compare_logs(printed[0], printed[1])), .type = json_type};
    }

    /// The drawings are texts in the response: a student's program may print anything.
    Response rays(const Request& request) {
        const std::vector<std::string> printed = about_pixel(request, "--rays", drawings_);
        return {.body = "[" + json(printed[0]) + "," + json(printed[1]) + "]", .type = json_type};
    }

    const ViewSettings& settings_;
    std::array<RenderQueue, 2> pictures_;  // mine never waits for the reference's
    RenderQueue stories_;
    RenderQueue drawings_;
    StageRunner runner_{settings_};
    Watcher watcher_{settings_};
};

}  // namespace

int view(const ViewSettings& settings) {
    Host host(settings.port);
    Viewer viewer(settings);
    host.serve(
        "", [&](const Request& request) { return viewer.answer(request); }, [&] { viewer.stop(); });
    return 0;
}

}  // namespace rt
