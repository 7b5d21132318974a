// The part of HTTP that one page needs.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rt {

/// A GET request, the only supported method.
struct Request {
    std::string path;                               ///< up to the '?'
    std::map<std::string, std::string> parameters;  ///< after the '?', still percent-encoded
    std::string host;
};

/// Nothing is loaded from other origins, nothing runs that is written in the page itself, and no
/// other page may embed this one.
inline constexpr const char* strict_policy =
    "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; img-src data:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

struct Response {
    int status = 200;
    std::string body = "";
    std::string type = "text/plain; charset=utf-8";
    std::string report = "";             ///< the output of a picture's program
    std::string policy = strict_policy;  ///< Content-Security-Policy
};

/// An error response. Thrown by a handler, and sent instead of its response.
struct Refusal {
    int status = 400;
    std::string reason;
};

/// Parses the head of a request, up to its empty line. Throws Refusal if it is malformed.
[[nodiscard]] Request parse_request(std::string_view head);

/// A required parameter, a number in the range. Throws Refusal if it is missing or out of range.
[[nodiscard]] double number(const Request& request, const std::string& name, double min,
                            double max);
/// The same for a whole number.
[[nodiscard]] int whole_number(const Request& request, const std::string& name, int min, int max);

[[nodiscard]] std::string to_bytes(const Response& response);

/// The text as a JSON string, with its quotes.
[[nodiscard]] std::string json(std::string_view text);

}  // namespace rt
