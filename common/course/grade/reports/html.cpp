#include "common/course/grade/reports/html.hpp"

#include "common/system/escaping.hpp"
#include "common/system/files.hpp"
#include "common/system/translation.hpp"

#include <algorithm>
#include <map>

namespace rt::grade {

namespace {

/// The style sheet of all pages.
const std::string& style() {
    static const std::string text =
        read_text(fs::path(RAYSTEPS_ROOT) / "common/course/grade/reports/page.css");
    return text;
}

constexpr std::size_t most_rows = 15;
constexpr std::size_t most_folded = 200;

}  // namespace

std::string escaped(std::string_view text) {
    static const std::map<char, const char*> entities = {
        {'<', "&lt;"}, {'>', "&gt;"}, {'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
    std::string out;
    for (const char each : readable(text)) {
        const auto entity = entities.find(each);
        out += entity == entities.end() ? std::string(1, each) : entity->second;
    }
    return out;
}

std::string page(std::string_view title, std::string_view body) {
    // The page can run no script, even if untrusted text escaped the escaping.
    return "<!DOCTYPE html>\n<html lang=\"" + tr("en") +
           "\">\n<head>\n<meta charset=\"utf-8\"/>\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"script-src 'none'; "
           "object-src 'none'; base-uri 'none'; form-action 'none'\"/>\n<title>" +
           escaped(title) + "</title>\n<style>\n" + style() + "</style>\n</head>\n<body>\n" +
           std::string(body) + "</body>\n</html>\n";
}

std::string percent(int part, int whole) {
    return whole == 0 ? "" : std::to_string(100 * part / whole) + " %";
}

std::string counted(int count, const std::string& what) {
    const std::string sentence = "{number} " + what + (count == 1 ? "" : "s");
    return tr(sentence, {{"number", count}});
}

std::string data_address(std::string_view kind, std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out = "data:" + std::string(kind) + ";base64,";
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= count ? digits[word >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

std::string text_cell(const std::string& text) {
    return "<td class=\"text\">" + escaped(text) + "</td>";
}

std::string share_cell(const std::string& kind, int part, int whole, const std::string& words) {
    const std::string share = std::to_string(std::min(100, 100 * part / std::max(whole, 1)));
    return "<td class=\"" + kind + "\" style=\"--share: " + share + "%\">" + words + "</td>";
}

std::string row(const std::string& cells) {
    return "<tr>" + cells + "</tr>\n";
}

std::string table(const std::string& kind, const std::string& rows) {
    return "<div class=\"scroll\"><table class=\"" + kind + "\">\n" + rows + "</table></div>\n";
}

std::string first_rows(const std::string& head, const std::vector<std::string>& rows) {
    std::string first = head;
    std::string folded = head;
    const std::size_t shown = std::min(rows.size(), most_rows + most_folded);
    for (std::size_t i = 0; i < shown; ++i) (i < most_rows ? first : folded) += rows[i];
    if (rows.size() <= most_rows) return table("list", first);
    const Values values = {{"number", rows.size() - most_rows}, {"shown", most_folded}};
    const std::string summary = shown < rows.size()
                                    ? tr("{number} more, of which {shown} are here", values)
                                    : tr("{number} more", values);
    return table("list", first) + "<details><summary>" + summary + "</summary>\n" +
           table("list", folded) + "</details>\n";
}

}  // namespace rt::grade
