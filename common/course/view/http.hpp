// As much of HTTP as one page needs.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace rt {

/// What is asked for; only ever with GET.
struct Request {
    std::string path;                               ///< up to the '?'
    std::map<std::string, std::string> parameters;  ///< behind it, as they came
    std::string host;
};

struct Response {
    int status = 200;
    std::string body = "";
    std::string type = "text/plain; charset=utf-8";
    std::string report = "";  ///< what a picture's program said
};

/// Thrown by whoever answers, and sent in place of an answer.
struct Refusal {
    int status = 400;
    std::string reason;
};

/// The request that the head, up to its empty line, makes. Throws Refusal if it makes none.
[[nodiscard]] Request parse_request(std::string_view head);

/// A parameter that must be there and be a number in the range, or the request is refused.
[[nodiscard]] double number(const Request& request, const std::string& name, double min,
                            double max);
/// The same, of whole numbers.
[[nodiscard]] int whole_number(const Request& request, const std::string& name, int min, int max);

/// The response as it is sent.
[[nodiscard]] std::string to_bytes(const Response& response);

/// The text as a JSON string, with its quotes.
[[nodiscard]] std::string json(std::string_view text);

}  // namespace rt
