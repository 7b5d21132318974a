#include "common/contract/difference_texts.hpp"

#include "common/system/text.hpp"

namespace rt::contract {

namespace {

using Kind = Type::Kind;

bool asks_for_hit(const Call& call) {
    return call.callee->answer == &type_of<std::optional<Real>>();
}

/// The arguments, without an interval that is everything.
std::string arguments_code(const Call& call) {
    std::string text;
    for (const Value& argument : call.arguments) {
        const bool whole = argument.type == &type_of<Interval>() && argument.parts[0].number == 0 &&
                           argument.parts[1].number == double(infinity);
        if (asks_for_hit(call) && whole) continue;
        text += (text.empty() ? "" : ", ") + code(argument);
    }
    return text;
}

/// hits(ray, shape, t), and behind it the interval, if that is not everything.
std::string hits_code(const Call& call, const Value& t) {
    const std::string ray_and_shape = code(call.arguments[0]) + ", " + code(call.arguments[1]);
    const std::string all = arguments_code(call);
    return "hits(" + ray_and_shape + ", " + code(t) + all.substr(ray_and_shape.size()) + ")";
}

bool is_given(const Value& value) {
    return value.type->kind == Kind::real || value.type == &type_of<Vec2>() || is_vec3(value);
}

/// gives("name", what, value) for each part that `gives` can compare.
std::string gives_lines(const std::string& name, const std::string& what, const Value& value) {
    if (is_given(value)) {
        const std::string type = is_vec3(value)                   ? "Vec3"
                                 : value.type->kind == Kind::real ? "Real"
                                                                  : "Vec2";
        const bool braced = type != "Real";
        return "CHECK(gives(\"" + name + "\", " + what + ", " +
               (braced ? type + code(value) : "Real(" + code(value) + ")") + "));\n";
    }
    if (value.type->kind == Kind::truth)
        return std::string(value.number != 0 ? "CHECK(" : "CHECK_FALSE(") + what + ");\n";
    if (value.type->kind == Kind::integer) return "CHECK(" + what + " == " + code(value) + ");\n";
    if (value.type->kind == Kind::optional) {
        if (value.parts.empty()) return "CHECK_FALSE(" + what + ");\n";
        return gives_lines(name, "(*" + what + ")", value.parts.front());
    }
    std::string lines;  // of more than one part: in a block, after the call
    for (std::size_t i = 0; i < value.parts.size(); ++i) {
        const bool named = value.type->kind == Kind::record;
        const std::string part = what + (named ? std::string(".") + value.type->parts[i].name
                                               : "[" + std::to_string(i) + "]");
        lines += gives_lines(part, part, value.parts[i]);
    }
    return lines;
}

}  // namespace

std::string paste_line(const Call& call, const Value& expected) {
    if (asks_for_hit(call))
        return "CHECK(" +
               (expected.parts.empty() ? "misses(" + arguments_code(call) + ")"
                                       : hits_code(call, expected.parts.front())) +
               ");";
    if (call.callee->name == "normal")
        return "CHECK(normal_is(" + arguments_code(call) + ", " +
               code(without_signed_zeros(expected)) + "));";
    const std::string called = call.callee->name + "(" + arguments_code(call) + ")";
    const Value answer = without_signed_zeros(expected);
    if (answer.type->kind == Kind::truth || answer.type->kind == Kind::integer ||
        is_given(answer)) {
        std::string line = gives_lines(call.callee->name, called, answer);
        line.pop_back();
        return line;
    }
    std::string block = "{\n    const auto answer = " + called + ";\n";
    for (const std::string& line : lines_of(gives_lines("answer", "answer", answer)))
        block += "    " + line + "\n";
    return block + "}";
}

std::string answer_text(const Call& call, const Answer& answer) {
    if (!answer.value) return "your code " + answer.failure;
    if (!asks_for_hit(call)) return code(without_signed_zeros(*answer.value));
    return answer.value->parts.empty() ? "no hit"
                                       : "a hit at t = " + code(answer.value->parts.front());
}

}  // namespace rt::contract
