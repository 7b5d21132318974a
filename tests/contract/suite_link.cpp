// A suite's other link: whatever it asks, a worker of another process answers. Every test case has
// a worker of its own; once that is gone, the rest of the case fails at once.
//
// RAYSTEPS_WORKER         the worker's program
// RAYSTEPS_SECONDS        how long it may take for an answer (default 20)
// RAYSTEPS_CASE_SECONDS   how long for all answers of a case (default 120)
// RAYSTEPS_SUITE_SECONDS  how long for all answers of the suite (default 600)
// RAYSTEPS_RECORD         a file that all questions are written to, if it is set
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "tests/contract/asking.hpp"
#include "tests/contract/picture_question.hpp"
#include "tests/contract/stub.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/drawn.hpp"
#include "tests/kit/light_points.hpp"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>

namespace rt::contract {

namespace {

double seconds(const char* variable, double otherwise) {
    const char* said = std::getenv(variable);
    return said == nullptr ? otherwise : std::strtod(said, nullptr);
}

/// Seconds that are spent while an answer is waited for.
class Budget {
public:
    Budget(double whole, std::string what) : left_(whole), what_(std::move(what)) {}

    [[nodiscard]] double left() const { return left_; }
    [[nodiscard]] bool is_spent() const { return left_ <= 0; }
    [[nodiscard]] const std::string& words() const { return what_; }
    void spend(double seconds) { left_ -= seconds; }

private:
    double left_;
    std::string what_;
};

/// What stands between a suite and its worker. Pictures are asked for by several threads.
class Link {
public:
    std::string ask(const std::string& question) {
        const std::lock_guard lock(mutex_);
        if (!gone_.empty()) throw NoAnswer(gone_);
        const auto start = std::chrono::steady_clock::now();
        try {
            if (suite_.is_spent()) throw NoAnswer(suite_.words());
            if (!worker_) worker_ = std::make_unique<Worker>(program());
            const double most = std::min({answer_seconds, case_.left(), suite_.left()});
            const std::string answer = worker_->ask(question, most);
            spend(start);
            return answer;
        } catch (const NoAnswer& no_answer) {
            spend(start);
            gone_ = "Your code " +
                    std::string(suite_.is_spent()  ? suite_.words()
                                : case_.is_spent() ? case_.words()
                                                   : no_answer.what()) +
                    ".";
            worker_ = nullptr;
            throw NoAnswer(gone_);
        }
    }

    void record(const std::string& question) {
        const std::lock_guard lock(mutex_);
        if (!record_.is_open()) return;
        const auto size = std::uint32_t(question.size());
        record_.write(reinterpret_cast<const char*>(&size), sizeof size) << question;
    }

    void start_afresh() {
        const std::lock_guard lock(mutex_);
        worker_ = nullptr;
        gone_.clear();
        case_ = budget_of_case();
    }

private:
    static std::string program() {
        const char* said = std::getenv("RAYSTEPS_WORKER");
        if (said == nullptr) throw CannotStart("RAYSTEPS_WORKER must name a worker's program");
        return said;
    }

    static Budget budget_of_case() {
        return {seconds("RAYSTEPS_CASE_SECONDS", 120), "took longer than one case may take"};
    }

    void spend(std::chrono::steady_clock::time_point start) {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
        case_.spend(spent.count());
        suite_.spend(spent.count());
    }

    static std::ofstream open_record() {
        const char* said = std::getenv("RAYSTEPS_RECORD");
        return said == nullptr ? std::ofstream() : std::ofstream(said, std::ios::binary);
    }

    std::mutex mutex_;
    std::unique_ptr<Worker> worker_;
    const double answer_seconds = seconds("RAYSTEPS_SECONDS", 20);
    Budget case_ = budget_of_case();
    Budget suite_{seconds("RAYSTEPS_SUITE_SECONDS", 600), "took longer than all cases may take"};
    std::string gone_;  ///< why there is no answer any more in this case
    std::ofstream record_ = open_record();
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
        link().record("");  // so that a reader sees where a case begins
    }
};

CATCH_REGISTER_LISTENER(WorkerForEachCase)

}  // namespace

std::string answer_of_worker(const std::string& question) {
    link().record(question);
    return link().ask(question);
}

}  // namespace rt::contract

namespace rt {

Image drawn(const Scene& scene, const Look& look, int every) {
    using namespace contract;
    return picture_in(link().ask(picture_question(scene, look, every)), scene.resolution);
}

std::vector<Vec3> light_points(const Light& light, Vec3 from, std::uint32_t seed, int count) {
    using namespace contract;
    Writer question;
    put(question, Number{.stage = 0, .place = light_points_place});
    put(question, light);
    put(question, from);
    put(question, seed);
    put(question, count);
    const std::string bytes = link().ask(question.bytes());
    Reader reader(bytes);
    auto points = get<std::vector<Vec3>>(reader);
    reader.end();
    if (points.size() != std::size_t(count)) throw Malformed("another number of points");
    return points;
}

}  // namespace rt
