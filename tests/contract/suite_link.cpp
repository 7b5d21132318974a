// A suite's other link: whatever it asks, a worker of another process answers. Every test case has
// a worker of its own; once that is gone, the rest of the case fails at once.
//
// RAYSTEPS_WORKER   the worker's program
// RAYSTEPS_SECONDS  how long it may take for an answer (default 20)
// RAYSTEPS_RECORD   a file that all questions are written to, if it is set
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "tests/contract/asking.hpp"
#include "tests/contract/scene_bytes.hpp"
#include "tests/contract/stub.hpp"

#include "tests/kit/catch.hpp"
#include "tests/kit/drawn.hpp"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <mutex>
#include <thread>

namespace rt::contract {

namespace {

/// What stands between a suite and its worker. Pictures are asked for by several threads.
class Link {
public:
    std::string ask(const std::string& question) {
        const std::lock_guard lock(mutex_);
        if (!gone_.empty()) throw NoAnswer(gone_);
        try {
            if (!worker_) worker_ = std::make_unique<Worker>(program());
            return worker_->ask(question, seconds());
        } catch (const NoAnswer& no_answer) {
            gone_ = "Your code " + std::string(no_answer.what()) + ".";
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
    }

private:
    static std::string program() {
        const char* said = std::getenv("RAYSTEPS_WORKER");
        if (said == nullptr) throw CannotStart("RAYSTEPS_WORKER must name a worker's program");
        return said;
    }

    static double seconds() {
        const char* said = std::getenv("RAYSTEPS_SECONDS");
        return said == nullptr ? 20 : std::strtod(said, nullptr);
    }

    static std::ofstream open_record() {
        const char* said = std::getenv("RAYSTEPS_RECORD");
        return said == nullptr ? std::ofstream() : std::ofstream(said, std::ios::binary);
    }

    std::mutex mutex_;
    std::unique_ptr<Worker> worker_;
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

/// One question a picture: asked ray by ray, it would take a hundred times as long as it does.
Image drawn(const Scene& scene, const Look& look, int every) {
    using namespace contract;
    Writer question;
    put(question, Number{.stage = 0, .place = picture_place});
    put_scene(question, scene);
    put(question, look);
    put(question, every);
    const std::string bytes = link().ask(question.bytes());
    Reader reader(bytes);
    Image image(scene.resolution);
    const std::size_t size = image.pixels.size();
    image.pixels = get<std::vector<Rgb>>(reader);
    reader.end();
    if (image.pixels.size() != size) throw Malformed("a picture of another size");
    return image;
}

}  // namespace rt
