#include "common/contract/probes.hpp"

#include "common/contract/contracts.hpp"
#include "common/math/vector.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace rt::contract {

namespace {

constexpr const char* head =
    "# Calls that distinguish the known mistakes of this stage from the reference and each other,\n"
    "# with the answers, and the cases that each mistake fails. Made by choose_probes from the\n"
    "# suite's own calls, not by hand.\n";

/// "mistake name: sentence" behind its first word.
Mistake read_mistake(const std::string& line) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) throw Malformed("no sentence: " + line);
    return {.name = line.substr(0, colon), .sentence = line.substr(colon + 2)};
}

std::size_t place_of(const Probes& probes, const std::string& mistake) {
    const auto found = std::ranges::find(probes.mistakes, mistake, &Mistake::name);
    if (found == probes.mistakes.end()) throw Malformed("no mistake " + mistake);
    return std::size_t(found - probes.mistakes.begin());
}

/// "answer | names"
void read_wrong(const Probes& probes, Probe& probe, const std::string& line) {
    const std::size_t bar = line.rfind(" | ");
    if (bar == std::string::npos) throw Malformed("an answer without an owner: " + line);
    const Answer answer = read_answer(*probe.call.callee, std::string_view(line).substr(0, bar));
    for (const std::string& name : words_of(line.substr(bar + 3)))
        probe.mistaken[place_of(probes, name)] = answer;
}

/// "functions: name"
SuiteCase read_case(int stage, const std::string& line) {
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) throw Malformed("no name of a case: " + line);
    const std::vector<std::string> names = words_of(line.substr(0, colon));
    SuiteCase read{.name = line.substr(colon + 2), .calls = {}};
    for (const Callee& callee : callees())
        if (callee.stage == stage && std::ranges::find(names, callee.name) != names.end())
            read.calls.push_back(&callee);
    return read;
}

/// "..x. name": an x for each case that the mistake fails.
void read_fails(Probes& probes, const std::string& line) {
    const std::vector<std::string> words = words_of(line);
    if (words.size() != 2 || words[0].size() != probes.cases.size())
        throw Malformed("not a mark for each case, and a mistake: " + line);
    std::vector<bool>& fails = probes.mistakes[place_of(probes, words[1])].fails;
    for (const char mark : words[0]) fails.push_back(mark == 'x');
}

/// Within the suites' tolerance; of an open function, exactly: the last digits count there.
double tolerance_of(const Probes& probes, const Call& call) {
    return is_open(probes, *call.callee) ? 0 : right_tolerance;
}

std::string answer_text(const Probes& probes, const Call& call, const Answer& answer) {
    return is_open(probes, *call.callee) && answer.value ? code(*answer.value) : code(answer);
}

std::string cases_text(const Probes& probes) {
    std::string text;
    for (const auto& [name, calls] : probes.cases) {
        std::vector<std::string> names;  // one of overloads
        for (const Callee* const callee : calls)
            if (std::ranges::find(names, callee->name) == names.end())
                names.push_back(callee->name);
        text += "case ";
        for (const std::string& each : names) text += (&each == names.data() ? "" : " ") + each;
        text += ": " + name + "\n";
    }
    for (const Mistake& mistake : probes.mistakes) {
        if (mistake.fails.empty()) continue;
        text += "fails ";
        for (const bool fails : mistake.fails) text += fails ? 'x' : '.';
        text += " " + mistake.name + "\n";
    }
    return text.empty() ? "" : "\n" + text;
}

}  // namespace

CaseResults read_case_results(const std::string& report) {
    CaseResults results;
    std::string name;
    for (const std::string& line : lines_of(report)) {
        if (const auto next = after("case ", line)) results[name = *next] = false;
        if (line == "passed") results[name] = true;
    }
    return results;
}

Probes read_probes(const std::string& text) {
    Probes probes;
    for (const std::string& line : lines_of(text)) {
        const std::size_t blank = line.find(' ');
        const std::string word = line.substr(0, blank);
        const std::string rest = blank == std::string::npos ? "" : line.substr(blank + 1);
        if (word == "stage") probes.stage = std::stoi(rest);
        if (word == "mistake") probes.mistakes.push_back(read_mistake(rest));
        if (word == "case") probes.cases.push_back(read_case(probes.stage, rest));
        if (word == "fails") read_fails(probes, rest);
        if (word == "open") probes.open = words_of(rest);
        if (word == "call") probes.probes.push_back({.call = read_call(probes.stage, rest)});
        if (word != "right" && word != "wrong") continue;
        if (probes.probes.empty()) throw Malformed("an answer without a call");
        Probe& probe = probes.probes.back();
        if (word == "right") {
            probe.right = read_answer(*probe.call.callee, rest);
            probe.mistaken.assign(probes.mistakes.size(), probe.right);
        } else {
            read_wrong(probes, probe, rest);
        }
    }
    if (probes.stage == 0) throw Malformed("no stage");
    return probes;
}

std::string text_of(const Probes& probes) {
    std::string text = head + ("stage " + std::to_string(probes.stage)) + "\n";
    for (const Mistake& mistake : probes.mistakes)
        text += "mistake " + mistake.name + ": " + mistake.sentence + "\n";
    if (!probes.open.empty()) {
        text += "open";
        for (const std::string& name : probes.open) text += " " + name;
        text += "\n";
    }
    text += cases_text(probes);
    for (const auto& [call, right, mistaken] : probes.probes) {
        text += "\ncall " + code(call) + "\nright " + answer_text(probes, call, right) + "\n";
        const double within = tolerance_of(probes, call);
        std::vector<bool> counted(mistaken.size());
        for (std::size_t i = 0; i < mistaken.size(); ++i) {
            if (counted[i] || same(mistaken[i], right, within)) continue;
            text += "wrong " + answer_text(probes, call, mistaken[i]) + " |";
            for (std::size_t j = i; j < mistaken.size(); ++j) {
                if (counted[j] || !same(mistaken[j], mistaken[i], within)) continue;
                counted[j] = true;
                text += " " + probes.mistakes[j].name;
            }
            text += "\n";
        }
    }
    return text;
}

bool is_open(const Probes& probes, const Callee& callee) {
    return std::ranges::find(probes.open, callee.name) != probes.open.end();
}

bool is_recognisable(const Probes& probes, const std::string& mistake) {
    const std::size_t place = place_of(probes, mistake);
    return std::ranges::any_of(probes.probes, [&](const Probe& probe) {
        return !same(probe.mistaken[place], probe.right, tolerance_of(probes, probe.call));
    });
}

std::string content_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) throw std::runtime_error("cannot read " + file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

namespace {

/// A number of an answer, and the least difference that counts.
struct Measure {
    double value;
    double floor;
};

constexpr double relative_difference = 0.1;

/// The origin of a ray: the height above the surface and the distance aside, in errors of the
/// point. A right start is less than ten errors above.
std::vector<Measure> start_of(const ShadingPoint& surface, Vec3 start) {
    constexpr double floor = 0.3;
    const Vec3 offset = start - surface.point;
    const double height = dot(offset, surface.geometric_normal) / surface.error;
    const double length_squared = dot(offset, offset) / (surface.error * surface.error);
    const double aside = std::sqrt(std::max(length_squared - height * height, 0.0));
    const bool right = height > 1 - floor && height < 10 && aside < floor;
    return {{right ? 1 : height, floor}, {right ? 0 : aside, floor}};
}

/// The length of the interval behind the light, relative to the light's distance. A right end is
/// a little before it.
Measure end_of(const ShadingPoint& surface, Vec3 light, const ShadowRay& way) {
    constexpr double little = 0.002;
    constexpr double right = -1;  // as no other
    const Vec3 there = light - surface.point;
    const double distance = std::max(length(there), length(light - at(way.ray, way.interval.min)));
    const double rounding = 16 * unit_roundoff * (1 + length(light) / distance);
    if (std::isinf(way.interval.max)) return {double(way.interval.max), rounding};
    const double behind = dot(at(way.ray, way.interval.max) - light, unit(there)) / distance;
    if (behind > -little && behind < -rounding) return {right, rounding};
    return {behind, rounding};
}

std::vector<Measure> measures(const ShadingPoint& surface, Vec3 light, const ShadowRay& way) {
    std::vector<Measure> all = start_of(surface, at(way.ray, way.interval.min));
    all.push_back(end_of(surface, light, way));
    return all;
}

/// The direction, in lengths of the ray's.
std::vector<Measure> measures(const Ray& ray, const ShadingPoint& surface, const Ray& reflected) {
    constexpr double floor = 0.02;
    std::vector<Measure> all = start_of(surface, reflected.origin);
    for (glm::length_t i = 0; i < 3; ++i)
        all.push_back({reflected.direction[i] / length(ray.direction), floor});
    return all;
}

/// The point's distance from the light's center, and the part of it towards the surface.
std::vector<Measure> measures(const Light& light, Vec3 from, Vec3 point) {
    constexpr double floor = 0.02;
    const Vec3 away = from - light.position;
    const Vec3 on_light = point - light.position;
    const double size = light.radius > 0 ? double(light.radius) : 1;
    const double axis = length(away);
    return {{length(on_light) / size, floor},
            {axis > 0 ? dot(on_light, away) / axis / size : 0, floor}};
}

std::vector<Measure> measures(const Call& call, const Value& answer) {
    const std::vector<Value>& arguments = call.arguments;
    if (call.callee->name == "shadow_ray")
        return measures(*as<ShadingPoint>(arguments[0]), *as<Vec3>(arguments[1]),
                        *as<ShadowRay>(answer));
    if (call.callee->name == "mirrored")
        return measures(*as<Ray>(arguments[0]), *as<ShadingPoint>(arguments[1]), *as<Ray>(answer));
    if (call.callee->name == "sample_light")
        return measures(*as<Light>(arguments[0]), *as<Vec3>(arguments[1]), *as<Vec3>(answer));
    return {};
}

bool close_measures(const Measure& a, const Measure& b) {
    if (std::isnan(a.value) || std::isnan(b.value))
        return std::isnan(a.value) && std::isnan(b.value);
    if (std::isinf(a.value) || std::isinf(b.value)) return a.value == b.value;
    const double size = std::max(std::abs(a.value), std::abs(b.value));
    return std::abs(a.value - b.value) <= std::max(relative_difference * size, a.floor);
}

}  // namespace

bool same_kind(const Call& call, const Answer& got, const Answer& expected) {
    if (!got.value || !expected.value) return same(got, expected, 0);
    const std::vector<Measure> all = measures(call, *got.value);
    return std::ranges::equal(all, measures(call, *expected.value), close_measures);
}

bool is_compared_by_kind(const Callee& callee) {
    return callee.name == "shadow_ray" || callee.name == "mirrored" ||
           callee.name == "sample_light";
}

}  // namespace rt::contract
