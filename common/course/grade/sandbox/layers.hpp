// The layers of the sandbox that work on this machine, and that of files (Landlock).
#pragma once

#include <string>
#include <vector>

namespace rt::grade {

struct Layer {
    std::string name;
    bool holds = false;
    bool needed = false;  ///< nothing is graded without it
};

/// Tries each layer in a process of its own, from the strongest to the weakest.
[[nodiscard]] std::vector<Layer> layers();

/// True if all needed layers work.
[[nodiscard]] bool hold(const std::vector<Layer>& layers);

/// Rules that make only the listed files accessible to a process. They have no effect on a kernel
/// without Landlock.
class Landlock {
public:
    /// The kernel's version of Landlock, 0 without Landlock.
    [[nodiscard]] static int version();

    Landlock();
    ~Landlock();
    Landlock(const Landlock&) = delete;
    Landlock& operator=(const Landlock&) = delete;

    /// Files, or folders with their whole contents. A missing file needs no rule.
    void let_read(const std::string& path);
    void let_write(const std::string& path);
    void let_run(int program);

    /// Applies the rules permanently. Returns true if they are in force.
    [[nodiscard]] bool put_on() const;

private:
    void let(const std::string& path, unsigned long rights);
    void let(int file, unsigned long rights);

    unsigned long rights_ = 0;
    int rules_ = -1;
};

}  // namespace rt::grade
