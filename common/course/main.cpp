// `./course`, after the script of that name has built it.
#include "common/course/build/project.hpp"
#include "common/course/command_line.hpp"
#include "common/system/input_error.hpp"
#include "common/system/terminal.hpp"
#include "common/system/translation.hpp"

#include <csignal>
#include <iostream>

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // a file above the size limit is an error to report
    try {
        rt::read_project_translations("course");
        rt::read_project_translations("program");
        const int status = rt::Commands().run(argc, argv);
        rt::finish_output();
        return status;
    } catch (const rt::InputError& error) {
        std::cerr << rt::tr_text(error.what()) << '\n';
    } catch (const rt::ProgramError& error) {
        std::cerr << error.what();
    } catch (const std::exception& error) {  // from the system: a folder of another user
        std::cerr << rt::tr_text(std::string("error: ") + error.what()) << '\n';
    }
    return 2;
}
