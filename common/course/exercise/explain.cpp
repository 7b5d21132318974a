#include "common/course/exercise/commands.hpp"

#include "common/course/build/build.hpp"
#include "common/course/build/static_data.hpp"
#include "common/course/exercise/failing_question.hpp"
#include "common/course/exercise/log_diff.hpp"
#include "common/course/exercise/suite.hpp"
#include "common/system/files.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"
#include "common/system/wrap.hpp"

namespace rt {

namespace {

Both<std::string> explain_both(const ComparisonRequest& contest, const std::string& pixel) {
    const StatusLine status(tr("explaining the pixel …"));
    return run_both(contest, [&](const std::string& program, auto limit) {
        return answer(program, contest, {"--pixel", pixel}, limit);
    });
}

/// The differences of two explanations. A loop of the student's is compiled once more, to log its
/// calls.
LogDiff compare_explanations(const ComparisonRequest& contest, const std::string& pixel,
                             const Both<std::string>& both) {
    const LogDiff diff = compare_logs(both.mine, both.reference);
    if (!diff.has_own_loop || contest.all_mine) return diff;
    const std::string logging = stage_target(contest.stage, "_logging");
    build({logging});
    const std::string mine = answer(logging, contest, {"--pixel", pixel}, reference_limit);
    return compare_logs(mine, both.reference, Writer::own_loop);
}

std::string color_text(Rgb color) {
    return std::to_string(color[0]) + ", " + std::to_string(color[1]) + ", " +
           std::to_string(color[2]);
}

/// Reports that a pixel has another color in the picture, after other rays, than when its ray alone
/// is traced.
void show_dependence(int stage, const std::string& pixel, const std::string& drawn,
                     const std::string& explanation) {
    const bool is_a_mean = explanation.find("other rays through the pixel") != std::string::npos ||
                           explanation.find("the mean of more rays") != std::string::npos;
    const std::string alone = value_in_log(explanation, "8-bit");
    if (drawn.empty() || is_a_mean || alone == drawn) return;
    const std::string kept =
        joined(static_variables(stage, compiled_files()), &StaticVariable::name);
    const Values values = {{"pixel", pixel}, {"drawn", drawn}, {"alone", alone}, {"names", kept}};
    const std::string words =
        tr("In your picture, the pixel {pixel} is {drawn}; its ray alone gives {alone}. Your "
           "picture depends on the rays before.",
           values) +
        " " +
        (kept.empty() ? tr("The usual cause is a variable without a value, an index out of range, "
                           "or a static variable.")
                      : tr("The usual cause is the static or global variable {names}.", values));
    print_line("\n" + wrapped(words));
}

/// Explains the question of a call to both workers.
std::string explain_call(const FailingQuestion& question, int stage, const std::string& all) {
    const std::string mine = stage_target(stage, "_worker_double");
    const std::string reference = stage_target(stage, "_reference_worker");
    build({"explain_call", mine, reference});
    const auto explained = [&](const std::string& worker) {
        return run_captured({(build_folder / "explain_call").string(), std::to_string(stage),
                             question.call, (build_folder / worker).string()},
                            least_limit);
    };
    const ProcessResult both[] = {explained(mine), explained(reference)};
    if (both[0].status != 0 || both[1].status != 0) return "";
    return text(compare_logs(both[0].output, both[1].output), all);
}

/// Explains the question of a scene to both programs.
std::string explain_scene(const FailingQuestion& question, ComparisonRequest contest,
                          const std::string& all) {
    const std::string scene = "renders/" + stage_target(contest.stage, "_failing.rt");
    write_text(project_folder / scene, question.scene);
    contest.words = {(project_folder / scene).string()};
    contest.words.insert(contest.words.end(), question.options.begin(), question.options.end());
    const auto both = explain_both(contest, question.pixel);
    return tr("The scene is in {file}.", {{"file", scene}}) + "\n" +
           text(compare_explanations(contest, question.pixel, both), all);
}

/// Explains the first failing question of the last check: the picture has no difference to explain.
void explain_failing_question(const ComparisonRequest& contest) {
    const std::string number = std::to_string(contest.stage);
    std::vector<CaseResult> results;
    for (const char* suite : {"_test_double", "_trace_test_double"}) {
        const std::vector<CaseResult> more = last_results(stage_target(contest.stage, suite));
        results.insert(results.end(), more.begin(), more.end());
    }
    const std::optional<FailingQuestion> question =
        failing_question(results, shown_case(contest.stage));
    if (!question) {
        print_line(tr("The suite tests what the picture does not show: ./course check {stage}",
                      {{"stage", number}}));
        return;
    }
    const std::string all = contest.all ? "" : "./course explain " + number + " --all";
    const std::string explained = question->call.empty()
                                      ? explain_scene(*question, contest, all)
                                      : explain_call(*question, contest.stage, all);
    read_project_translations(step_path(contest.stage, "sentences"));
    print_line(tr("The picture cannot show it. The first failing case of the last check: {case}",
                  {{"case", tr(question->case_name)}}) +
               "\n");
    print(explained);
}

}  // namespace

int explain_pixel(const ComparisonRequest& contest, std::string pixel) {
    build_both(contest);
    std::string drawn;  // the color of the pixel in the student's picture
    if (pixel.empty()) {
        const Comparison comparison = compare_both(contest);
        print_line(summary(comparison));
        if (!comparison.center) {
            if (contest.words.empty()) explain_failing_question(contest);
            show_parts(contest);
            return 0;
        }
        pixel = std::to_string(comparison.center->row) + "," +
                std::to_string(comparison.center->column);
        drawn = color_text(comparison.side_by_side[*comparison.center]);
    }
    const auto both = explain_both(contest, pixel);
    const LogDiff diff = compare_explanations(contest, pixel, both);
    const std::string all = contest.all ? "" : explain_command(contest) + " " + pixel + " --all";
    print(text(diff, all));
    show_dependence(contest.stage, pixel, drawn, both.mine);
    show_parts(contest);
    return 0;
}

}  // namespace rt
