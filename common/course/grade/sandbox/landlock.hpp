// The files that a process may access (Landlock).
#pragma once

#include <string>

namespace rt::grade {

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
