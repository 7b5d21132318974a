#include "tests/grading/seal_ground.hpp"

#include <chrono>
#include <cstddef>
#include <fstream>

namespace rt {

Ground::Ground() {
    fs::permissions(folder, fs::perms(0755));
    fs::copy_file(RAYSTEPS_SEALED, folder / "sealed");
    fs::copy_file(RAYSTEPS_ATTACKER, folder / "attacker");
    fs::copy_file(RAYSTEPS_ATTACKER, folder / "launcher");  // not counted as an attack
    fs::create_directory(folder / "scratch");
    fs::permissions(folder / "scratch", fs::perms(0777));
    std::ofstream(folder / "secret") << "expected values";
    fs::permissions(folder / "secret", fs::perms(0666));
}

bool is_ordinary(const Who& who) {
    return geteuid() != 0 || (!who.before.empty() && who.before[0] == "setpriv");
}

std::vector<Who> everybody(const Ground& ground) {
    std::vector<Who> all{{"whoever runs this", {}}};
    const std::string user = std::to_string(ordinary_user);
    if (geteuid() == 0)
        all.push_back({"an ordinary user",
                       {"setpriv", "--reuid=" + user, "--regid=" + user, "--clear-groups"}});
    for (std::size_t i = 0, count = all.size(); i < count; ++i) {
        Who who = all[i];
        who.name += ", without namespaces";
        who.before.insert(who.before.end(), {ground.folder / "launcher", "--no-namespaces"});
        all.push_back(who);
    }
    return all;
}

Command sealed(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    Command command = who.before;
    command.push_back(ground.folder / "sealed");
    command.insert(command.end(), limits.begin(), limits.end());
    command.insert(command.end(), {"--", ground.folder / "attacker"});
    command.insert(command.end(), attack.begin(), attack.end());
    return command;
}

ProcessResult run(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    return run_captured(sealed(ground, who, limits, attack), std::chrono::seconds(60));
}

int status(const Ground& ground, const Who& who, const Words& limits, const Words& attack) {
    return run(ground, who, limits, attack).status;
}

int processes_of(const fs::path& program) {
    int count = 0;
    for (const auto& each : fs::directory_iterator("/proc")) {
        std::ifstream in(each.path() / "cmdline");
        std::string line;
        std::getline(in, line, '\0');
        count += line == program.string();
    }
    return count;
}

}  // namespace rt
