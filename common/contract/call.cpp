#include "common/contract/call.hpp"

#include "common/contract/contracts.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <array>
#include <map>

namespace rt::contract {

namespace {

constexpr double answer_seconds = 1;  // they take microseconds
constexpr double all_seconds = 10;

std::vector<Callee> all_callees() {
    std::vector<Callee> all;
    std::map<int, int> places;
    for_each_function([&]<Word Name, auto Pointer>(int stage, Function<Name, Pointer>) {
        using Callable = Function<Name, Pointer>;
        Callee callee{.stage = stage,
                      .place = places[stage]++,
                      .name = Callable::name,
                      .answer = &type_of<typename Callable::Answer>()};
        [&]<class... Each>(std::type_identity<std::tuple<Each...>>) {
            (callee.parameters.push_back(&type_of<Each>()), ...);
        }(std::type_identity<typename Callable::Arguments>());
        all.push_back(callee);
    });
    return all;
}

std::string first_word(const std::string& text) {
    return text.substr(0, text.find_first_of(" :"));
}

/// The function that a call in the text is of, by its name, and then by whether the arguments can
/// be parsed.
std::optional<Call> read_as(const Callee& callee, std::string_view text) {
    if (!text.starts_with(callee.name + "(")) return std::nullopt;
    text.remove_prefix(callee.name.size() + 1);
    Call call{.callee = &callee};
    try {
        for (const Type* const type : callee.parameters) {
            if (type->kind == Type::Kind::record && !text.starts_with(type->name))
                return std::nullopt;
            call.arguments.push_back(read_value(*type, text));
            if (text.starts_with(", ")) text.remove_prefix(2);
        }
    } catch (const Malformed&) {
        return std::nullopt;
    }
    if (text != ")") return std::nullopt;
    return call;
}

}  // namespace

const std::vector<Callee>& callees() {
    static const std::vector<Callee> all = all_callees();
    return all;
}

std::string question_of(const Call& call) {
    Writer question;
    put(question, Number{.stage = std::uint8_t(call.callee->stage),
                         .place = std::uint8_t(call.callee->place)});
    for (const Value& argument : call.arguments) put_value(question, argument);
    return question.bytes();
}

Call call_of(std::string_view question) {
    Reader reader(question);
    const auto [stage, place] = get<Number>(reader);
    for (const Callee& callee : callees()) {
        if (callee.stage != stage || callee.place != place) continue;
        Call call{.callee = &callee};
        for (const Type* const type : callee.parameters)
            call.arguments.push_back(get_value(*type, reader));
        reader.end();
        return call;
    }
    throw Malformed("no such function");
}

std::string code(const Call& call) {
    const auto text = [](const Value& argument) { return code(argument); };
    return call.callee->name + "(" + joined(call.arguments, text) + ")";
}

Call read_call(int stage, std::string_view text) {
    for (const Callee& callee : callees()) {
        if (callee.stage != stage) continue;
        if (auto call = read_as(callee, text)) return *call;
    }
    throw Malformed("not a call of stage " + std::to_string(stage) + ": " + std::string(text));
}

std::string code(const Answer& answer) {
    constexpr int digits = 14;
    return answer.value ? code(*answer.value, digits) : first_word(answer.failure);
}

Answer read_answer(const Callee& callee, std::string_view text) {
    for (const char* const word : {"crashed", "gave", "ended", "threw", "closed", "wrote", "was"})
        if (text == word) return {.value = std::nullopt, .failure = word};
    Answer answer{.value = read_value(*callee.answer, text)};
    if (!text.empty()) throw Malformed("more text after the answer");
    return answer;
}

bool same(const Answer& got, const Answer& expected, double within) {
    if (!got.value || !expected.value)
        return !got.value && !expected.value &&
               first_word(got.failure) == first_word(expected.failure);
    return same(*got.value, *expected.value, within);
}

Answer Asked::operator()(const Call& call) {
    if (gone_.empty() && used_ + (worker_ ? worker_->used() : 0) > all_seconds)
        gone_ = "was not run any more, since it took too long";
    if (!gone_.empty()) return {.value = std::nullopt, .failure = gone_};
    try {
        if (!worker_) worker_ = std::make_unique<Worker>(program_);
        const std::string bytes = worker_->ask(question_of(call), answer_seconds);
        Reader reader(bytes);
        Answer answer{.value = get_value(*call.callee->answer, reader)};
        reader.end();
        return answer;
    } catch (const NoAnswer& no_answer) {
        const std::string failure = no_answer.what();
        if (worker_ && !worker_->alive()) {
            used_ += worker_->used();
            worker_ = nullptr;
            // After one timeout, no further worker is started.
            if (--left_ == 0 || first_word(failure) == "gave")
                gone_ = "was not run any more, since it " + failure;
        }
        return {.value = std::nullopt, .failure = failure};
    }
}

std::vector<Answer> Asked::operator()(const std::vector<Call>& calls) {
    std::vector<Answer> answers;
    answers.reserve(calls.size());
    for (const Call& call : calls) answers.push_back((*this)(call));
    return answers;
}

bool is_place(const std::string& name) {
    constexpr std::array places = {"origin", "center",   "point",    "apex",        "a",   "b",
                                   "c",      "position", "vertices", "translation", "min", "max"};
    return std::ranges::find(places, name) != places.end();
}

bool is_basis(const Value& value) {
    return value.type == &type_of<Basis>();
}

std::optional<Call> call_of_suite(int stage, std::string text) {
    if (text.empty() || text.back() != ')') return std::nullopt;
    try {
        return read_call(stage, text);
    } catch (const Malformed&) {
        text.pop_back();
    }
    try {
        return read_call(stage, text + ", Interval{.min = 0, .max = infinity})");
    } catch (const Malformed&) {
        return std::nullopt;
    }
}

std::vector<Call> failing_calls(int stage, const std::string& report) {
    std::vector<Call> calls;
    std::string question;  // on several lines, before the first entry of a failure: "|   got: …"
    bool is_question = true;
    for (const std::string& line : lines_of(report)) {
        if (line.starts_with("case ")) {
            question.clear();
            is_question = true;
        }
        if (!line.starts_with("| ") || !is_question) continue;
        const std::string text = line.substr(2);
        const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
        is_question = start != 2;
        if (is_question)
            question += (question.empty() ? "" : " ") + text.substr(start);
        else if (auto call = call_of_suite(stage, question))
            calls.push_back(std::move(*call));
    }
    return calls;
}

}  // namespace rt::contract
