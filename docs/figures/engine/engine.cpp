// Compiled once in each precision.
#include "docs/figures/engine/engine.hpp"

#include "docs/figures/engine/describe.hpp"
#include "docs/figures/engine/questions.hpp"

#include <array>
#include <map>
#include <string>

namespace rt::book {

namespace {

using Answer = void (*)(contract::Reader& question, contract::Writer& answer);

struct Engine {
    std::map<int, Answer> answers;
    std::string description = "[";
    std::vector<char> room;
    std::string result;
};

Engine made_engine() {
    Engine engine;
    std::array<int, contract::stage_count + 1> places{};
    contract::for_each_function<0>([&]<class F>(int stage, F) {
        const int place = places.at(std::size_t(stage))++;
        engine.answers[stage << 8 | place] = F::answer;
        engine.description +=
            (engine.description == "[" ? "" : ",") + json_function<F>(stage, place);
    });
    engine.description += "]";
    return engine;
}

Engine& engine() {
    static Engine only = made_engine();
    return only;
}

}  // namespace

}  // namespace rt::book

char* engine_room(std::size_t size) {
    auto& room = rt::book::engine().room;
    if (size > room.size()) room.resize(size);
    return room.data();
}

std::size_t engine_ask(std::size_t size) {
    using namespace rt::contract;
    auto& engine = rt::book::engine();
    engine.result.clear();
    Reader question(std::string_view(engine.room.data(), size));
    const auto [stage, place] = get<Number>(question);
    const auto found = engine.answers.find(stage << 8 | place);
    if (found == engine.answers.end()) return 0;
    Writer answer;
    found->second(question, answer);
    engine.result = answer.bytes();
    return engine.result.size();
}

std::size_t engine_describe() {
    auto& engine = rt::book::engine();
    engine.result = engine.description;
    return engine.result.size();
}

const char* engine_result() {
    return rt::book::engine().result.data();
}
