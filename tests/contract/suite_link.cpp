// The link of a suite to a worker: another process answers each of its queries. Every test case has
// a worker of its own; when that ends, the rest of the case fails at once.
//
// RAYSTEPS_WORKER         the worker's program
// RAYSTEPS_SECONDS        limit for an answer, by the worker's stopwatch (default 20)
// RAYSTEPS_CASE_SECONDS   limit for all answers of a case (default 120)
// RAYSTEPS_SUITE_SECONDS  limit for all answers of the suite (default 600)
// RAYSTEPS_RECORD         a file for a record of all queries, if it is set
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "common/contract/asking.hpp"
#include "common/contract/call.hpp"
#include "common/contract/light_points.hpp"
#include "common/contract/picture_question.hpp"
#include "common/contract/rendered.hpp"

#include "common/stages/reasons.hpp"
#include "tests/contract/change.hpp"
#include "tests/contract/stub.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/report.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <mutex>

namespace rt::contract {

namespace {

constexpr std::size_t longest_question = 4000;
constexpr const char* too_long_a_case = "took longer than one case may take";

double seconds(const char* variable, double otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtod(said, nullptr);
}

/// The link of a suite to its worker. Several threads query pictures.
class Link {
public:
    std::string ask(const std::string& question) {
        const std::lock_guard lock(mutex_);
        if (!gone_.empty()) throw NoAnswer(gone_);
        try {
            if (suite_left_ <= 0) throw NoAnswer(too_long_a_suite);
            if (!worker_) worker_ = std::make_unique<Worker>(program());
            return worker_->ask(question, answer_seconds, std::min(case_seconds, suite_left_));
        } catch (const NoAnswer& no_answer) {
            const double used = end_worker();
            gone_ = no_answer_start +
                    std::string(suite_left_ <= 0       ? too_long_a_suite
                                : used >= case_seconds ? too_long_a_case
                                                       : no_answer.what()) +
                    ".";
            throw NoAnswer(gone_);
        }
    }

    void record(const std::string& question) {
        const std::lock_guard lock(mutex_);
        if (!record_.is_open()) return;
        const auto size = std::uint32_t(question.size());
        record_.write(reinterpret_cast<const char*>(&size), sizeof size) << question;
    }

    /// Stores the query as sent, after the change.
    void keep_changed(const std::string& question) {
        const std::lock_guard lock(mutex_);
        changed_ = question;
    }

    /// The last changed query of the case, as text.
    std::string words_on_change() {
        const std::lock_guard lock(mutex_);
        if (changed_.empty()) return "";
        if (changed_[0] == 0)  // not of one function
            return std::uint8_t(changed_[1]) == trace_place
                       ? "  changed:  the whole scene was rotated, moved and scaled, and its "
                         "colors "
                         "were\n            exchanged and dimmed; the answer is changed back\n"
                       : "  changed:  a larger picture was drawn, and its middle is tested\n";
        const std::string question = code(call_of(changed_));
        if (question.size() > longest_question) return "";
        return "  changed:  everything was rotated, moved and scaled, which keeps the answer; at "
               "last\n"
               "            " +
               question;
    }

    void start_afresh() {
        const std::lock_guard lock(mutex_);
        changed_.clear();
        end_worker();
        gone_.clear();
    }

private:
    static std::string program() {
        const char* said = std::getenv("RAYSTEPS_WORKER");
        if (said == nullptr) throw CannotStart("RAYSTEPS_WORKER must name a worker's program");
        return said;
    }

    /// The time that it has used.
    double end_worker() {
        const double used = worker_ ? worker_->used() : 0;
        worker_ = nullptr;
        suite_left_ -= used;
        return used;
    }

    static std::ofstream open_record() {
        const char* said = std::getenv("RAYSTEPS_RECORD");
        return said == nullptr ? std::ofstream() : std::ofstream(said, std::ios::binary);
    }

    std::mutex mutex_;
    std::unique_ptr<Worker> worker_;
    const double answer_seconds = seconds("RAYSTEPS_SECONDS", 20);
    const double case_seconds = seconds("RAYSTEPS_CASE_SECONDS", 120);
    double suite_left_ = seconds("RAYSTEPS_SUITE_SECONDS", 600);
    std::string gone_;  ///< why there is no answer any more in this case
    std::ofstream record_ = open_record();
    std::string changed_;
};

Link& link() {
    static Link link;
    return link;
}

#ifdef CATCH_VERSION_MAJOR
#if CATCH_VERSION_MAJOR >= 3
using Listener = Catch::EventListenerBase;
#else
using Listener = Catch::TestEventListenerBase;
#endif
#endif

struct WorkerForEachCase : Listener {
    using Listener::Listener;

    void testCaseStarting(const Catch::TestCaseInfo& info) override {
        Listener::testCaseStarting(info);
        link().start_afresh();
        draw_change(info.name, info.tagsAsString().find("[exact]") != std::string::npos);
        link().record("");  // marks the start of a case for the reader
        remark_on_failure = [] { return link().words_on_change(); };
    }
};

CATCH_REGISTER_LISTENER(WorkerForEachCase)

}  // namespace

std::string answer_of_worker(const std::string& question) {
    link().record(question);
    if (change() != nullptr) link().keep_changed(question);
    return link().ask(question);
}

}  // namespace rt::contract

namespace rt {

Image rendered(const Scene& scene, const RenderSettings& settings, int every) {
    using namespace contract;
    const Change* const now = every == 1 ? change() : nullptr;
    const Scene asked = now == nullptr ? scene : enlarged(scene, *now);
    const std::string question = picture_question(asked, settings, every);
    link().record(question);
    if (asked.resolution.width != scene.resolution.width) link().keep_changed(question);
    return middle_of(picture_in(link().ask(question), asked.resolution), scene.resolution);
}

Color traced(const Scene& scene, const RenderSettings& settings) {
    using namespace contract;
    const Change* const now = change();
    Writer question;
    put(question, Number{.stage = 0, .place = trace_place});
    put_scene(question, now == nullptr ? scene : changed(scene, settings, *now));
    put(question, settings);
    link().record(question.bytes());
    if (now != nullptr) link().keep_changed(question.bytes());
    const std::string bytes = link().ask(question.bytes());
    Reader reader(bytes);
    const auto color = get<Color>(reader);
    reader.end();
    return now == nullptr ? color : changed_back(color, scene, settings, *now);
}

std::vector<Vec3> light_points(const Light& light, Vec3 from, std::uint32_t seed, int count) {
    using namespace contract;
    const Change* const now = change();
    Writer question;
    put(question, Number{.stage = 0, .place = light_points_place});
    put(question, now == nullptr ? light : changed(light, *now, now->any));
    put(question, now == nullptr ? from : rt::transformed(from, now->any));
    put(question, seed);
    put(question, count);
    link().record(question.bytes());
    const std::string bytes = link().ask(question.bytes());
    Reader reader(bytes);
    auto points = get<std::vector<Vec3>>(reader);
    reader.end();
    if (points.size() != std::size_t(count)) throw Malformed("wrong number of points");
    if (now != nullptr)
        for (Vec3& point : points) point = moved_back(point, now->any);
    return points;
}

}  // namespace rt
