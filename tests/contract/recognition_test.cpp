// Known mistakes, recognized by their answers and by the cases that fail.
#include "common/contract/recognition.hpp"

#include "tests/kit/catch.hpp"

using namespace rt;
using namespace rt::contract;

namespace {

/// A mistake of the sphere that fails one case of three, and its answers.
struct Tangent {
    Probes probes = read_probes(
        "stage 3\nmistake tangent_lost: You test > for >=.\n"
        "case intersect: a tangent\ncase intersect: a small sphere\ncase normal: a normal\n"
        "fails x.. tangent_lost\n"
        "call intersect(Ray{{0, 1, 5}, {0, 0, -1}}, Sphere{{0, 0, 0}, 1}, Interval{0, infinity})\n"
        "right 5\nwrong std::nullopt | tangent_lost\n"
        "call normal(Sphere{{0, 0, 0}, 1}, {0, 0, 1})\nright {0, 0, 1}\n");
    std::vector<Answer> answers = {probes.probes[0].mistaken[0], probes.probes[1].right};

    [[nodiscard]] bool is_named(const CaseResults& results) const {
        return !recognized(probes, answers, results).empty();
    }
};

}  // namespace

TEST_CASE("a mistake is recognized only if the cases that fail are those that it fails") {
    Tangent known;
    CHECK(known.is_named({{"a tangent", false}, {"a small sphere", true}, {"a normal", true}}));
    CHECK_FALSE(
        known.is_named({{"a tangent", false}, {"a small sphere", false}, {"a normal", true}}));
    CHECK_FALSE(
        known.is_named({{"a tangent", true}, {"a small sphere", true}, {"a normal", true}}));
    CHECK_FALSE(
        known.is_named({{"a tangent", false}, {"a small sphere", true}, {"a normal", false}}));
    // A crash before the other cases, and a case that was added since.
    CHECK(known.is_named({{"a tangent", false}}));
    CHECK(known.is_named({{"a tangent", false}, {"another", false}}));
}

TEST_CASE("a mistake that can be made in two functions is recognized in one") {
    const Probes probes = read_probes(
        "stage 9\nmistake falls_off: Light does not fall off.\n"
        "case diffuse_term: diffuse\ncase specular_term: specular\n"
        "fails xx falls_off\n"
        "call reflected({0, 0, 1}, {0, 0, 1})\nright {0, 0, 1}\n"
        "call diffuse_term(ShadingPoint{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 0, "
        "Material{{1, 1, 1}, 1, 2, 0}}, Light{{0, 0, 2}, 1, {1, 1, 1}, 0})\n"
        "right {1, 1, 1}\nwrong {Real(0.25), Real(0.25), Real(0.25)} | falls_off\n"
        "call specular_term(ShadingPoint{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 0, "
        "Material{{1, 1, 1}, 1, 2, 0}}, Light{{0, 0, 2}, 1, {1, 1, 1}, 0})\n"
        "right {1, 1, 1}\nwrong {Real(0.25), Real(0.25), Real(0.25)} | falls_off\n");
    const Answer right = probes.probes[1].right;
    const Answer wrong = probes.probes[1].mistaken[0];
    const Answer reflected = probes.probes[0].right;
    const auto named = [&](const Answer& diffuse, const Answer& specular,
                           const CaseResults& results) {
        return recognized(probes, {reflected, diffuse, specular}, results).size();
    };
    CHECK(named(wrong, wrong, {{"diffuse", false}, {"specular", false}}) == 1);
    CHECK(named(wrong, right, {{"diffuse", false}, {"specular", true}}) == 1);
    CHECK(named(wrong, right, {{"diffuse", true}, {"specular", false}}) == 0);
    CHECK(named(right, right, {{"diffuse", true}, {"specular", true}}) == 0);
}

TEST_CASE("of two mistakes that explain one function, the one that explains more is recognized") {
    const Probes probes = read_probes(
        "stage 9\nmistake eye_reversed: You take the ray for V.\n"
        "mistake reflected_sign: R has the wrong sign.\n"
        "case reflected: reflected\ncase specular_term: specular\n"
        "fails .x eye_reversed\nfails xx reflected_sign\n"
        "call reflected({0, 0, 1}, {0, 0, 1})\nright {0, 0, 1}\n"
        "wrong {0, 0, -1} | reflected_sign\n"
        "call specular_term(ShadingPoint{{0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, 0, "
        "Material{{1, 1, 1}, 1, 2, 0}}, Light{{0, 0, 2}, 1, {1, 1, 1}, 0})\n"
        "right {1, 1, 1}\nwrong {0, 0, 0} | eye_reversed reflected_sign\n");
    const Answer& right = probes.probes[0].right;
    const Answer& turned = probes.probes[0].mistaken[1];
    const Answer& black = probes.probes[1].mistaken[0];
    const auto both =
        recognized(probes, {turned, black}, {{"reflected", false}, {"specular", false}});
    REQUIRE(both.size() == 1);
    CHECK(both.front().mistake.name == "reflected_sign");
    const auto one = recognized(probes, {right, black}, {{"reflected", true}, {"specular", false}});
    REQUIRE(!one.empty());
    CHECK(one.front().mistake.name == "eye_reversed");
}

TEST_CASE("the right answer of an earlier part is no mistake") {
    const Probes probes = read_probes(
        "stage 11\nmistake half: You go half way round.\n"
        "mistake disc: Not finished: a disc. Next: the ball.\n");
    CHECK_FALSE(probes.mistakes[0].is_earlier_part());
    CHECK(probes.mistakes[1].is_earlier_part());
}

TEST_CASE("a mistake is recognized beside another one, in another function") {
    Tangent known;
    known.answers[1].value->parts[2].number = -1;
    CHECK(known.is_named({{"a tangent", false}, {"a small sphere", true}, {"a normal", false}}));
    CHECK_FALSE(
        known.is_named({{"a tangent", false}, {"a small sphere", false}, {"a normal", false}}));
}

namespace {

/// Two mistakes in a function that has many right answers. An answer that differs from the
/// reference's is not enough to recognize them: the cases that fail must be theirs, too.
struct OpenFunction {
    Probes probes = read_probes(
        "stage 11\nmistake half: You go half way round.\nmistake disc: You aim at a disc.\n"
        "open sample_light\ncase sample_light: even\ncase sample_light: seen\n"
        "fails x. half\nfails xx disc\n"
        "call sample_light(Light{{0, 4, 0}, 1, {1, 1, 1}, 2}, {0, 0, 0}, {0, 0})\n"
        "right {0, 2, 0}\nwrong {Real(0.001), 2, 0} | half\nwrong {1, 4, 0} | disc\n");

    /// The names for this answer, if the first case fails, or both.
    [[nodiscard]] std::string names(Vec3 answer, bool both_fail) const {
        Writer writer;
        put(writer, answer);
        Reader reader(writer.bytes());
        const std::vector<Answer> answers = {{.value = get_value(type_of<Vec3>(), reader)}};
        std::string names;
        for (const auto& [mistake, is_certain] :
             recognized(probes, answers, {{"even", false}, {"seen", !both_fail}}))
            names += mistake.name;
        return names;
    }
};

}  // namespace

TEST_CASE("a mistake in an open function is recognized by the cases and the kind of answer") {
    const OpenFunction function;
    CHECK(function.names({0, 2, 0}, false) == "half");
    CHECK(function.names({0, Real(2.001), Real(0.06)}, false) == "half");  // another basis
    CHECK(function.names({0, 4, 1}, true) == "disc");
    CHECK(function.names({0, 4, 1}, false).empty());
    CHECK(function.names({0, 2, 0}, true).empty());
}

namespace {

/// Two mistakes of the plane's t on the plane z = −k for k = 1, 2, …: twice the t of the first six,
/// and t of the last four, which are behind.
struct Planes {
    Probes probes;
    std::vector<Answer> answers;  ///< right ones

    explicit Planes(
        const std::string& mistakes = "mistake doubled: Twice.\nmistake behind: Behind.\n") {
        std::string text = "stage 4\n" + mistakes;
        for (int k = 1; k <= 10; ++k) {
            const std::string t = std::to_string(k + 2);
            text +=
                "call intersect(Ray{{0, 0, 0}, {0, 0, -1}}, Plane{{0, 0, -" + t +
                "}, {0, 0, 1}}, Interval{0, infinity})\n" +
                (k <= 6 ? "right " + t + "\nwrong " + std::to_string(2 * (k + 2)) + " | doubled\n"
                        : "right std::nullopt\nwrong -" + t + " | behind\n");
        }
        probes = read_probes(text);
        for (const Probe& probe : probes.probes) answers.push_back(probe.right);
    }

    void answer_as(std::size_t mistake, std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) answers[i] = probes.probes[i].mistaken[mistake];
    }

    [[nodiscard]] std::string names() const {
        std::string all;
        for (const auto& [mistake, is_certain] : recognized(probes, answers, {}))
            all += mistake.name + (is_certain ? " " : "? ");
        return all;
    }
};

}  // namespace

TEST_CASE("a mistake that explains every wrong answer is probable where some answers are right") {
    Planes planes;
    planes.answer_as(0, 0, 6);
    CHECK(planes.names() == "doubled ");
    planes.answers[0] = planes.probes.probes[0].right;
    CHECK(planes.names() == "doubled? ");
    for (std::size_t i = 0; i < 4; ++i) planes.answers[i] = planes.probes.probes[i].right;
    CHECK(planes.names().empty());
}

TEST_CASE("two mistakes in one function are both probable if they explain all wrong answers") {
    Planes planes;
    planes.answer_as(0, 0, 6);
    planes.answer_as(1, 6, 10);
    CHECK(planes.names() == "doubled? behind? ");
    planes.answers[9] = planes.probes.probes[0].right;
    CHECK(planes.names().empty());
    // The one that gives more of the wrong answers comes first.
    Planes other("mistake behind: Behind.\nmistake doubled: Twice.\n");
    other.answer_as(1, 0, 6);
    other.answer_as(0, 6, 10);
    CHECK(other.names() == "doubled? behind? ");
}

TEST_CASE("no mistake is probable in a function where one that is certain errs, too") {
    std::string text = "stage 4\nmistake doubled: Twice.\nmistake turned: Turned.\n";
    for (int k = 1; k <= 7; ++k) {
        const std::string t = std::to_string(k + 2);
        text += "call intersect(Ray{{0, 0, 0}, {0, 0, -1}}, Plane{{0, 0, -" + t +
                "}, {0, 0, 1}}, Interval{0, infinity})\nright " + t + "\nwrong " +
                (k <= 6 ? std::to_string(2 * (k + 2)) + " | doubled\n" : "std::nullopt | turned\n");
    }
    text +=
        "call normal(Plane{{0, 0, 0}, {0, 0, 1}}, {0, 0, 0})\nright {0, 0, 1}\n"
        "wrong {0, 0, -1} | turned\n";
    const Probes probes = read_probes(text);
    std::vector<Answer> answers;
    for (std::size_t i = 0; i < 8; ++i)
        answers.push_back(i < 5 ? probes.probes[i].mistaken[0] : probes.probes[i].right);
    REQUIRE(recognized(probes, answers, {}).size() == 1);
    CHECK(recognized(probes, answers, {}).front().mistake.name == "doubled");
    answers[7] = probes.probes[7].mistaken[1];
    REQUIRE(recognized(probes, answers, {}).size() == 1);
    CHECK(recognized(probes, answers, {}).front().mistake.name == "turned");
}

TEST_CASE("a constant function identifies nothing") {
    Planes planes;
    for (Answer& answer : planes.answers) answer = planes.probes.probes[9].right;
    CHECK(is_constant(planes.probes, planes.answers, *planes.probes.probes[0].call.callee));
    CHECK(planes.names().empty());
    for (Probe& probe : planes.probes.probes) probe.mistaken[0] = planes.answers[0];
    CHECK(planes.names().empty());
}

TEST_CASE("another right answer beside a mistake's own function does not identify it") {
    // The mistake was made beside another right estimate of the error, which fails no case.
    const Probes probes = read_probes(
        "stage 11\nmistake square: You aim at a square.\nopen sample_light visibility_error\n"
        "case sample_light: seen\ncase visibility_error: positive\nfails x. square\n"
        "call sample_light(Light{{0, 4, 0}, 1, {1, 1, 1}, 2}, {0, 0, 0}, {0, 0})\n"
        "right {0, 2, 0}\nwrong {1, 4, 0} | square\n"
        "call visibility_error(ShadowRays{.sent = 2, .reached = 1})\n"
        "right Real(0.3)\nwrong Real(0.35) | square\n"
        "call visibility_error(ShadowRays{.sent = 4, .reached = 1})\n"
        "right Real(0.2)\nwrong Real(0.25) | square\n");
    std::vector<Answer> answers;
    for (const Probe& probe : probes.probes) answers.push_back(probe.mistaken[0]);
    const CaseResults results = {{"seen", false}, {"positive", true}};
    CHECK(recognized(probes, answers, results).size() == 1);
    answers[0].value->parts[2].number = 40;
    CHECK(recognized(probes, answers, results).empty());
}

TEST_CASE("many misses alike do not identify a mistake whose numbers are others") {
    std::string text = "stage 4\nmistake reversed: Reversed.\n";
    for (int k = 1; k <= 12; ++k) {
        const std::string t = std::to_string(k + 2);
        text +=
            "call intersect(Ray{{0, 0, 0}, {0, 0, -1}}, Plane{{0, 0, -" + t +
            "}, {0, 0, 1}}, Interval{0, infinity})\n" +
            (k <= 2 ? "right std::nullopt\nwrong " + t : "right " + t + "\nwrong std::nullopt") +
            " | reversed\n";
    }
    const Probes probes = read_probes(text);
    std::vector<Answer> answers;
    for (const Probe& probe : probes.probes) answers.push_back(probe.mistaken[0]);
    CHECK(recognized(probes, answers, {}).size() == 1);
    answers[11] = probes.probes[11].right;  // where a detail differs
    CHECK(recognized(probes, answers, {}).size() == 1);
    answers[11] = answers[0];  // another formula's number
    CHECK(recognized(probes, answers, {}).empty());
}

TEST_CASE("a mistake that only misses is probable where almost all misses are its own") {
    std::string text = "stage 4\nmistake lost: Lost.\n";
    for (int k = 1; k <= 10; ++k) {
        const std::string t = std::to_string(k + 2);
        text += "call intersect(Ray{{0, 0, 0}, {0, 0, -1}}, Plane{{0, 0, -" + t +
                "}, {0, 0, 1}}, Interval{0, infinity})\nright " + t + "\n" +
                (k <= 7 ? "wrong std::nullopt | lost\n" : "");
    }
    const Probes probes = read_probes(text);
    std::vector<Answer> answers;
    for (const Probe& probe : probes.probes) answers.push_back(probe.mistaken[0]);
    answers[9] = answers[8];  // a detail of another formula
    CHECK(recognized(probes, answers, {}).size() == 1);
    for (std::size_t i = 0; i < 4; ++i) answers[i] = probes.probes[i].right;
    CHECK(recognized(probes, answers, {}).empty());
}
