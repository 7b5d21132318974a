#include "common/course/exercise/commands.hpp"

#include "common/course/build/project.hpp"
#include "common/course/exercise/workbook.hpp"
#include "common/system/input_error.hpp"
#include "common/system/keys.hpp"
#include "common/system/process.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <chrono>
#include <cstdio>
#include <functional>
#include <optional>
#include <string>

namespace rt {

namespace {

/// The stage that is watched.
class Watch {
public:
    explicit Watch(int stage) : stage_(stage) {}

    /// Until q is pressed.
    void run() {
        using namespace std::chrono_literals;
        for (char key = 0; key != 'q'; key = keys_.pressed(100ms)) {
            const bool is_saved = Workbook(stage_).fingerprint() != checked_;
            if (is_saved || key == 'r') {
                show([this] { check_again(); });
            } else if (key == 'h') {
                show([this] { show_hint(stage_, std::nullopt); });
            } else if (key == 'l') {
                show(show_progress);
            } else if (key == 'n') {
                go_on();
            }
        }
    }

private:
    /// Prints on a screen of its own, and below it the keys.
    void show(const std::function<void()>& content) {
        if (output_on_terminal() && terminal_is_capable())
            print("\033[H\033[2J\033[3J");
        else
            print_line("");
        std::fflush(stdout);
        try {
            content();
        } catch (const InputError& error) {
            print_line(tr_text(error.what()));
        } catch (const ProgramError& error) {
            print(error.what());
        }
        if (keys_.are_read())
            print_line("\n" + tr("{stage}: r check again, h hint, n next stage, l stages, q quit",
                                 {{"stage", stage_}}));
        else
            print_line("\n" + tr("waiting for a change of {folder}; Ctrl-C ends",
                                 {{"folder", step_path(stage_, "student")}}));
        finish_output();
    }

    void check_again() {
        checked_ = Workbook(stage_).fingerprint();
        check(stage_);
    }

    /// To the next stage, which is started if it is not, and if this one passes.
    void go_on() {
        const std::optional<int> next = next_stage(stage_);
        const bool is_done = Workbook(stage_).state() == State::done;
        show([&] {
            if (!is_done)
                throw InputError({}, tr("{stage} does not pass yet", {{"stage", name_of(stage_)}}));
            if (!next) throw InputError({}, tr("this is the last stage"));
            stage_ = *next;
            if (Workbook(stage_).files().empty()) start(stage_);
            check_again();
        });
    }

    int stage_;
    std::string checked_;  ///< the fingerprint of the files
    Keys keys_;
};

}  // namespace

void watch(int stage) {
    Watch(stage).run();
}

}  // namespace rt
