// HTML pages that contain untrusted text.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

/// readable() for HTML and XML, between tags and in quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// The bytes of a file as a URL: "data:image/png;base64,…".
[[nodiscard]] std::string data_address(std::string_view kind, std::string_view bytes);

/// A page with this body, which is HTML, and this title, which is plain text. It is well-formed XML
/// too.
[[nodiscard]] std::string page(std::string_view title, std::string_view body);

/// "83 %": rounded down, so that only a complete whole is 100 %; empty if `whole` is 0.
[[nodiscard]] std::string percent(int part, int whole);

/// "1 case", "2 cases"
[[nodiscard]] std::string counted(int count, const std::string& what);

}  // namespace rt::grade
