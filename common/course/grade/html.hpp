// Strangers' text in our pages.
#pragma once

#include <string>
#include <string_view>

namespace rt::grade {

/// The text as everybody can read it: UTF-8, of control characters only tab and line feed. What is
/// not is "�"; what turns the direction of writing is not either, since it can make "1 of 9" look
/// like another mark.
[[nodiscard]] std::string readable(std::string_view text);

/// The same, for HTML and XML, between tags and in quotes.
[[nodiscard]] std::string escaped(std::string_view text);

/// The address of a file or folder beside the page, whatever it is called.
[[nodiscard]] std::string address(std::string_view name);

/// The bytes of a file as an address of their own: "data:image/png;base64,…".
[[nodiscard]] std::string data_address(std::string_view kind, std::string_view bytes);

/// The page with this body, which is HTML, and this title, which is not. It is well-formed XML too.
[[nodiscard]] std::string page(std::string_view title, std::string_view body);

/// "83 %": rounded down, so that only what is whole is 100 %; of nothing, nothing.
[[nodiscard]] std::string percent(int part, int whole);

/// "1 case", "2 cases"
[[nodiscard]] std::string counted(int count, const std::string& what);

}  // namespace rt::grade
