#include "tests/kit/for_all.hpp"

#include "tests/kit/seed.hpp"

#include <array>
#include <cmath>

namespace rt {

namespace {

thread_local bool is_drawing = false;

/// Until the end of a scope, inputs are random.
struct DrawingInputs {
    DrawingInputs() { is_drawing = true; }
    ~DrawingInputs() { is_drawing = false; }
    DrawingInputs(const DrawingInputs&) = delete;
    DrawingInputs& operator=(const DrawingInputs&) = delete;
};

Verdict replay(const Property& property, const std::vector<double>& choices) {
    Random random(choices);
    return property(random);
}

/// Plainer values for one choice, the plainest first.
std::array<double, 8> plainer(double choice) {
    return {0.5,
            0.75,
            0.25,
            1,
            0,
            std::round(choice * 8) / 8,
            std::round(choice * 64) / 64,
            std::round(choice * 1024) / 1024};
}

/// Makes each choice plainer while the property still fails, until none can be made plainer.
void shrink(const Property& property, std::vector<double>& choices) {
    for (bool changed = true; changed;) {
        changed = false;
        for (double& choice : choices) {
            const double before = choice;
            for (const double candidate : plainer(before)) {
                if (candidate == before) break;  // the rest is less plain
                choice = candidate;
                if (!replay(property, choices).holds) break;
                choice = before;
            }
            changed = changed || choice != before;
        }
    }
}

}  // namespace

bool is_drawn() {
    return is_drawing;
}

Verdict for_all(const Property& property, int cases) {
    const DrawingInputs until_the_end;
    const Failures failures_before = failures_of_case;
    for (int i = 0; i < cases; ++i) {
        Random random(draw_number(std::uint64_t(i)));
        if (property(random).holds) continue;
        std::vector<double> choices = random.choices();
        shrink(property, choices);
        const Verdict again = replay(property, choices);
        const std::string sentence =
            again.holds ? "the same call returned another result when it was repeated: your code "
                          "keeps a value from one call to the next, or uses one that is not set"
                        : again.sentence;
        failures_of_case = failures_before;  // without those of the search
        const std::string which =
            seed().secret ? "" : "RAYSTEPS_SEED=" + std::to_string(seed().number) + ", ";
        return verdict(false, sentence + "\n  random:   " + which + "case " +
                                  std::to_string(i + 1) + " of " + std::to_string(cases));
    }
    return {};
}

}  // namespace rt
