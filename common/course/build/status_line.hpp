// A line on the terminal about the work in progress, while nothing else is printed.
#pragma once

#include <string>

namespace rt {

/// A line on the standard error stream, if that is a terminal. It is erased at the end.
class StatusLine {
public:
    explicit StatusLine(const std::string& text);
    ~StatusLine();
    StatusLine(const StatusLine&) = delete;
    StatusLine& operator=(const StatusLine&) = delete;

    /// Replaces the text.
    void show(const std::string& text) const;

private:
    bool shown_;
};

}  // namespace rt
