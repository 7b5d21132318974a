#include "common/course/view/stage_runner.hpp"

#include "common/system/input_error.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <future>
#include <numbers>

namespace rt {

namespace {

constexpr std::size_t most_output = 4 << 20;  // the drawing of a scene with meshes
constexpr double degree = std::numbers::pi / 180;

bool is_camera(const std::string& line) {
    return line.size() > 1 && (line[0] == 'C' || line[0] == 'c') &&
           std::isspace(static_cast<unsigned char>(line[1])) != 0;
}

/// In the format of scenes, without an exponent.
std::string text(const TurnedCamera& camera) {
    return formatted("C %.6f,%.6f,%.6f %.9f,%.9f,%.9f %.6f", camera.x, camera.y, camera.z,
                     std::sin(camera.yaw * degree) * std::cos(camera.pitch * degree),
                     std::sin(camera.pitch * degree),
                     -std::cos(camera.yaw * degree) * std::cos(camera.pitch * degree), camera.fov);
}

std::optional<TurnedCamera> parse_camera(const std::string& line) {
    TurnedCamera camera;
    double x = 0;
    double y = 0;
    double z = 0;
    if (std::sscanf(line.c_str() + 1, "%lf,%lf,%lf %lf,%lf,%lf %lf", &camera.x, &camera.y,
                    &camera.z, &x, &y, &z, &camera.fov) != 7)
        return std::nullopt;
    camera.yaw = std::atan2(x, -z) / degree;
    camera.pitch = std::atan2(y, std::hypot(x, z)) / degree;
    return camera;
}

}  // namespace

fs::path program(const ViewSettings& settings, int stage, Whose whose) {
    const std::string name(stage_name(stage));
    return settings.build / (whose == Whose::mine ? name : name + "_reference_program");
}

fs::path scene_file(const ViewSettings& settings, int stage) {
    return settings.project / "scenes" / (name_of(stage) + ".rt");
}

std::vector<fs::path> student_files(const ViewSettings& settings, int stage) {
    return files_in(settings.project / "steps" / stage_name(stage) / "student", ".cpp");
}

SceneView scene_view(const ViewSettings& settings, int stage) {
    SceneView view;
    for (const std::string& line : lines_of(read_text(scene_file(settings, stage)))) {
        std::sscanf(line.c_str(), "R %d %d", &view.width, &view.height);
        if (is_camera(line) && !view.camera) view.camera = parse_camera(line);
    }
    return view;
}

StageRunner::StageRunner(const ViewSettings& settings) : settings_(settings) {
    // A scene's paths of meshes are relative to its own folder.
    std::error_code none;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(settings.project / "scenes", none))
        if (entry.is_directory(none))
            fs::create_directory_symlink(fs::absolute(entry.path()),
                                         folder_.path() / entry.path().filename(), none);
}

fs::path StageRunner::scene_of(const RenderRequest& picture_request) {
    const fs::path scene = scene_file(settings_, picture_request.stage);
    if (!picture_request.camera) return scene;
    std::string changed;
    bool found = false;
    for (const std::string& line : lines_of(read_text(scene))) {
        changed += (is_camera(line) && !found ? text(*picture_request.camera) : line) + "\n";
        found = found || is_camera(line);
    }
    const fs::path copy = folder_.path() / (std::to_string(++files_) + ".rt");
    write_text(copy, changed);
    return copy;
}

ProcessResult StageRunner::run(const RenderRequest& picture_request, Whose whose,
                               const std::string& scene, const Command& rest,
                               const std::atomic<bool>& cancelled) const {
    const SceneView view = scene_view(settings_, picture_request.stage);
    const fs::path asked = program(settings_, picture_request.stage, whose);
    if (!fs::exists(asked))
        throw InputError(
            {}, tr("{program} is not built yet", {{"program", asked.filename().string()}}));
    Command command = {asked.string(), scene, "--size",
                       std::to_string(std::max(1, view.width / picture_request.shrink)) + "x" +
                           std::to_string(std::max(1, view.height / picture_request.shrink))};
    command.insert(command.end(), picture_request.options.begin(), picture_request.options.end());
    command.insert(command.end(), rest.begin(), rest.end());
    ProcessResult ending = run_captured(command, settings_.render_limit, &cancelled, most_output);
    if (ending.out_of_time)
        ending.output += tr("ended after {seconds} s: does a loop never end?",
                            {{"seconds", settings_.render_limit.count()}}) +
                         "\n";
    else if (!ending.crash.empty())
        ending.output += tr("it crashed: {signal}", {{"signal", tr_text(ending.crash)}}) + "\n";
    replace_all(ending.output, scene, "scenes/" + name_of(picture_request.stage) + ".rt");
    return ending;
}

Picture StageRunner::draw(const RenderRequest& picture_request, Whose whose,
                          const std::atomic<bool>& cancelled) {
    const fs::path scene = scene_of(picture_request);
    const fs::path file = folder_.path() / (std::to_string(++files_) + ".png");
    ProcessResult ending =
        run(picture_request, whose, scene.string(), {"-o", file.string()}, cancelled);
    replace_all(ending.output, file.string() + ": ", "");
    Picture picture{.report = ending.output};
    if (ending.status == 0 && fs::exists(file)) picture.png = read_text(file);
    std::error_code none;
    fs::remove(file, none);
    if (picture_request.camera) fs::remove(scene, none);
    return picture;
}

std::vector<std::string> StageRunner::about_pixel(const RenderRequest& picture_request,
                                                  const std::string& option, int row, int column,
                                                  const std::atomic<bool>& cancelled) {
    const fs::path scene = scene_of(picture_request);
    const std::string pixel = std::to_string(row) + "," + std::to_string(column);
    const auto ask = [&](Whose whose) {
        try {
            return run(picture_request, whose, scene.string(), {option, pixel}, cancelled).output;
        } catch (const InputError& not_built) {
            return std::string(not_built.what()) + "\n";
        }
    };
    auto reference = std::async(std::launch::async, ask, Whose::reference);
    std::vector<std::string> printed = {ask(Whose::mine)};
    printed.push_back(reference.get());
    std::error_code none;
    if (picture_request.camera) fs::remove(scene, none);
    return printed;
}

bool RenderQueue::take(int page, int number, const Work& work) {
    Turn& turn = enter(page, number);
    try {
        if (!turn.cancelled) work(turn.cancelled);
    } catch (...) {
        leave(turn);
        throw;
    }
    return leave(turn);
}

RenderQueue::Turn& RenderQueue::enter(int page, int number) {
    std::unique_lock lock(mutex_);
    bool is_latest = true;
    for (Turn& turn : turns_) {
        if (turn.page != page) continue;
        if (turn.number > number)
            is_latest = false;
        else
            turn.cancelled = true;
    }
    changed_.notify_all();
    Turn& turn = turns_.emplace_back();
    turn.page = page;
    turn.number = number;
    turn.cancelled = over_ || !is_latest;
    changed_.wait(lock, [&] { return turn.cancelled || &turn == &turns_.front(); });
    return turn;
}

bool RenderQueue::leave(const Turn& turn) {
    const std::scoped_lock lock(mutex_);
    const bool finished = !turn.cancelled;
    turns_.remove_if([&](const Turn& other) { return &other == &turn; });
    changed_.notify_all();
    return finished;
}

void RenderQueue::cancel_all() {
    const std::scoped_lock lock(mutex_);
    over_ = true;
    for (Turn& turn : turns_) turn.cancelled = true;
    changed_.notify_all();
}

}  // namespace rt
