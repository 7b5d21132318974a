#include "common/course/view/http.hpp"

#include "common/system/escaping.hpp"
#include "common/system/parse_floating.hpp"
#include "common/system/text.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace rt {

namespace {

/// The text up to the separator. Removes both from `text`.
std::string_view take(std::string_view& text, std::string_view separator) {
    const std::size_t end = std::min(text.find(separator), text.size());
    const std::string_view taken = text.substr(0, end);
    text.remove_prefix(std::min(end + separator.size(), text.size()));
    return taken;
}

bool is_host(std::string_view name) {
    constexpr std::string_view host = "host";
    return std::equal(name.begin(), name.end(), host.begin(), host.end(), [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == b;
    });
}

std::from_chars_result parse_start(const std::string& text, double& value) {
    return parse_floating(text, value);
}

std::from_chars_result parse_start(const std::string& text, int& value) {
    return std::from_chars(text.data(), text.data() + text.size(), value);
}

template <class Number>
Number parse(const Request& request, const std::string& name, Number min, Number max) {
    const auto found = request.parameters.find(name);
    if (found == request.parameters.end()) throw Refusal{400, name + " is missing"};
    const std::string& text = found->second;
    Number value{};
    const auto [end, error] = parse_start(text, value);
    const bool fits = min <= value && value <= max;  // false for NaN
    if (error != std::errc() || end != text.data() + text.size() || !fits)
        throw Refusal{400, name + " must be a number from " + std::to_string(min) + " to " +
                               std::to_string(max)};
    return value;
}

}  // namespace

Request parse_request(std::string_view head) {
    const bool is_text = std::ranges::none_of(head, [](char c) {
        return (0 <= c && c < ' ' && c != '\r' && c != '\n' && c != '\t') || c == '\x7f';
    });
    if (!is_text) throw Refusal{400, "malformed request"};
    std::string_view line = take(head, "\r\n");
    const std::string_view method = take(line, " ");
    std::string_view target = take(line, " ");
    if (line.rfind("HTTP/1.", 0) != 0 || target.empty() || target[0] != '/')
        throw Refusal{400, "malformed request"};
    if (method != "GET") throw Refusal{405, "only GET is supported"};
    Request request{.path = std::string(take(target, "?"))};
    while (!target.empty()) {
        std::string_view value = take(target, "&");
        const std::string name(take(value, "="));
        request.parameters[name] = value;
    }
    int hosts = 0;
    while (!head.empty()) {
        std::string_view value = take(head, "\r\n");
        if (!is_host(take(value, ":"))) continue;
        request.host = trimmed(value);
        ++hosts;
    }
    if (hosts != 1) throw Refusal{400, "exactly one Host header is required"};
    return request;
}

double number(const Request& request, const std::string& name, double min, double max) {
    return parse(request, name, min, max);
}

int whole_number(const Request& request, const std::string& name, int min, int max) {
    return parse(request, name, min, max);
}

std::string to_bytes(const Response& response) {
    std::string bytes = "HTTP/1.1 " + std::to_string(response.status) +
                        " \r\nContent-Type: " + response.type +
                        "\r\nContent-Length: " + std::to_string(response.body.size());
    if (!response.report.empty()) bytes += "\r\nX-Report: " + percent_encoded(response.report);
    bytes +=
        "\r\nConnection: close"
        "\r\nCache-Control: no-store"
        "\r\nX-Content-Type-Options: nosniff"
        "\r\nReferrer-Policy: no-referrer"
        "\r\nCross-Origin-Resource-Policy: same-origin"
        "\r\nContent-Security-Policy: " +
        response.policy + "\r\n\r\n";
    return bytes + response.body;
}

std::string json(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : text) {
        const bool plain = (c < 0 || c >= ' ') && c != '"' && c != '\\' && c != '\x7f';
        quoted += plain ? std::string(1, c) : formatted("\\u%04x", int(c));
    }
    return quoted + "\"";
}

}  // namespace rt
