// Which files are within reach (Landlock).
#pragma once

#include <string>

namespace rt::grade {

/// The rules of a process that knows no file but these. Where the kernel has no Landlock, they
/// keep nothing out.
class Landlock {
public:
    /// The kernel's version of it, 0 if it has none.
    [[nodiscard]] static int version();

    Landlock();
    ~Landlock();
    Landlock(const Landlock&) = delete;
    Landlock& operator=(const Landlock&) = delete;

    /// Folders with all that is in them, or files. What is not there needs no rule.
    void let_read(const std::string& path);
    void let_write(const std::string& path);
    void let_run(int program);

    /// From here on, for good. Returns whether it is so.
    [[nodiscard]] bool put_on() const;

private:
    void let(const std::string& path, unsigned long rights);
    void let(int file, unsigned long rights);

    unsigned long rights_ = 0;
    int rules_ = -1;
};

}  // namespace rt::grade
