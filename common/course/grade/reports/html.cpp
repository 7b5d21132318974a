#include "common/course/grade/reports/html.hpp"

#include "common/system/escaping.hpp"
#include "common/system/translation.hpp"

#include <algorithm>

namespace rt::grade {

namespace {

constexpr std::string_view style = R"(
:root {
  color-scheme: light dark;
  --paper: #f7f6f3; --card: #fff; --ink: #22242a; --soft: #626673; --line: #dcdad4;
  --accent: #1f63a8; --wrong: #b3261e; --hint: #fff3d6; --none: #f6d3bd; --full: #bfe0d3;
}
@media (prefers-color-scheme: dark) {
  :root {
    --paper: #16181c; --card: #1e2126; --ink: #e4e5e8; --soft: #9a9fab; --line: #353941;
    --accent: #78b4f0; --wrong: #ff9d94; --hint: #3b3218; --none: #5a3320; --full: #1f4a3c;
  }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 72rem; padding: 1.5rem 1rem 4rem; background: var(--paper);
       color: var(--ink); font: 16px/1.5 system-ui, sans-serif; overflow-wrap: anywhere; }
h1 { font-size: 1.6rem; line-height: 1.2; margin: 0; }
h2 { font-size: 1.2rem; margin: 0; }
h3 { font-size: 1rem; margin: 1.25rem 0 .25rem; }
p { margin: .5rem 0; max-width: 44rem; }
a { color: var(--accent); }
small, .soft { color: var(--soft); font-weight: normal; }
small { font-size: .85rem; }
header, .line { display: flex; flex-wrap: wrap; gap: .25rem 1rem; align-items: baseline;
                justify-content: space-between; }
section { margin-top: 1.25rem; padding: 1rem clamp(.75rem, 3vw, 1.25rem); background: var(--card);
          border: 1px solid var(--line); border-radius: .6rem; }
pre { margin: .25rem 0; padding: .75rem 1rem; background: var(--paper); border-radius: .4rem;
      font: .85rem/1.5 ui-monospace, "DejaVu Sans Mono", monospace; overflow-x: auto; }
.wrong { border-left: 3px solid var(--wrong); }
.hint { padding: .6rem 1rem; background: var(--hint); border-radius: .4rem; }
figure { margin: .5rem 0; }
img { display: block; max-width: 100%; height: auto; border-radius: .3rem; background: #fff; }
img[src^="data:image/svg"] { width: 30rem; }
figcaption { color: var(--soft); font-size: .85rem; margin-top: .25rem; }
details { margin-top: .75rem; }
summary { cursor: pointer; color: var(--soft); }
ul { margin: .5rem 0; padding-left: 1.25rem; }
.stages { display: grid; grid-template-columns: repeat(auto-fill, minmax(10rem, 1fr)); gap: .5rem;
          margin: 1rem 0 0; padding: 0; list-style: none; }
.stages a { display: block; height: 100%; padding: .35rem .7rem; border: 1px solid var(--line);
            border-radius: .5rem; color: inherit; text-decoration: none; }
.stages small { display: block; }
.scroll { overflow-x: auto; margin: .75rem 0; }
table { border-collapse: separate; border-spacing: 2px; font-variant-numeric: tabular-nums;
        overflow-wrap: break-word; }
th, td { padding: .15rem .45rem; text-align: right; white-space: nowrap; border-radius: .25rem; }
th { font-weight: normal; color: var(--soft); }
td.text, th.text { text-align: left; vertical-align: top; }
td.text:last-child { white-space: normal; min-width: 13rem; }
.matrix { min-width: min(100%, 60rem); }
.matrix td, .matrix th { min-width: 2.6rem; }
.matrix th { vertical-align: bottom; }
th.stage span { display: inline-block; writing-mode: vertical-rl; transform: rotate(180deg); }
th.student { position: sticky; left: 0; max-width: 10rem; overflow: hidden; text-align: left;
             text-overflow: ellipsis; background: var(--card); border-radius: 0; }
@media (min-width: 50rem) { th.student { max-width: 18rem; } }
.share { background: color-mix(in oklab, var(--full) var(--share), var(--none)); }
th.student a { color: inherit; text-decoration: none; }
th.student a:hover { text-decoration: underline; }
.bar { min-width: 4rem; vertical-align: top; background: linear-gradient(to right,
       var(--full) var(--share), var(--paper) var(--share)); }
.share, .bar { -webkit-print-color-adjust: exact; print-color-adjust: exact; }
@media print {
  body { max-width: none; padding: 0; font-size: 10pt; background: none; }
  section { border: 0; padding: 0; }
  pre { white-space: pre-wrap; }
  pre, figure, tr { break-inside: avoid; }
  h2, h3 { break-after: avoid; }
  .scroll { overflow: visible; }
  .matrix { font-size: 7.5pt; }
}
)";

}  // namespace

std::string escaped(std::string_view text) {
    std::string out;
    for (const char each : readable(text)) switch (each) {
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '&':
                out += "&amp;";
                break;
            case '"':
                out += "&quot;";
                break;
            case '\'':
                out += "&#39;";
                break;
            default:
                out += each;
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
           escaped(title) + "</title>\n<style>" + std::string(style) +
           "</style>\n</head>\n<body>\n" + std::string(body) + "</body>\n</html>\n";
}

std::string percent(int part, int whole) {
    return whole == 0 ? "" : std::to_string(100 * part / whole) + " %";
}

std::string counted(int count, const std::string& what) {
    const std::string sentence = "{number} " + what + (count == 1 ? "" : "s");
    return tr(sentence, {{"number", std::to_string(count)}});
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

namespace {

constexpr std::size_t most_rows = 15;
constexpr std::size_t most_folded = 200;

}  // namespace

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
    const Values values = {{"number", std::to_string(rows.size() - most_rows)},
                           {"shown", std::to_string(most_folded)}};
    const std::string summary = shown < rows.size()
                                    ? tr("{number} more, of which {shown} are here", values)
                                    : tr("{number} more", values);
    return table("list", first) + "<details><summary>" + summary + "</summary>\n" +
           table("list", folded) + "</details>\n";
}

}  // namespace rt::grade
