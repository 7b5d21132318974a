// Single keys, without Enter.
#pragma once

#include <chrono>

namespace rt {

/// While one exists, the keys of the terminal are read one by one and not shown. The terminal is
/// restored at its end, and before a signal ends or stops the program. Ctrl-C and Ctrl-Z work as
/// ever. Does nothing if the standard input is no terminal, or not this program's to read.
class Keys {
public:
    Keys();
    ~Keys();
    Keys(const Keys&) = delete;
    Keys& operator=(const Keys&) = delete;

    [[nodiscard]] bool are_read() const { return are_read_; }

    /// The key that is pressed within the time; 0 if none is.
    [[nodiscard]] char pressed(std::chrono::milliseconds within) const;

private:
    bool are_read_;
};

}  // namespace rt
