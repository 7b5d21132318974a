#!/usr/bin/python3
"""Draws the figures of docs/figures/live as they start: draw_live.py ENGINE PROJECT FOLDER [FIGURE...]

Writes FOLDER/NAME.svg of each, without a script and with two sets of colors, as docs/figures/source/svg.cpp does. The title is
the page's alternative text. Status 77 where Chromium is missing, or the engine: a folder with engine_double.wasm.
"""
import http.server
import pathlib
import re
import sys
import tempfile
from xml.sax.saxutils import escape

engine, project, folder = (pathlib.Path(path).resolve() for path in sys.argv[1:4])
sys.path.insert(0, str(project / "tests/figures"))
import chromium

live = project / "docs/figures/live"
pages = "".join(page.read_text(encoding="utf-8") for page in sorted((project / "docs").glob("*.md")))
titles = {name: title for title, name in re.findall(r"!\[([^\]]*)\]\(figures/(\w+)\.svg\)\n+<!-- figure: \2 -->", pages)}

# Shapes and labels with attributes in place of styles, and two decimals.
draw = """(async () => {
  await import("/%s.js");
  const figure = new (customElements.get("rt-%s"))();
  await figure.connectedCallback();
  const [shapes, labels] = figure.back.children;
  for (const { place, knob } of figure.handles) if (knob.getAttribute("fill").includes("#24292f")) figure.sketch.mark(place, "given");
  figure.show();
  for (const element of figure.back.querySelectorAll("*")) {
    for (const [, name, value] of (element.getAttribute("style") ?? "").matchAll(/([a-z-]+): ([^;]+)/g)) element.setAttribute(name, value);
    for (const name of ["style", "class"]) element.removeAttribute(name);
    for (const { name, value } of Array.from(element.attributes)) {
      if (/^(none|inherit|0|round)$/.test(value) && /^(stroke|stroke-dasharray|stroke-linecap|font-size|dy)$/.test(name)) element.removeAttribute(name);
      else if (/^(d|points|c?[xy][12]?|r|width|height|stroke-width)$/.test(name))
        element.setAttribute(name, value.replace(/-?\\d+(\\.\\d+)?(e-\\d+)?/g, (number) => Math.round(100 * number + 1e-4) / 100));
    }
  }
  return [figure.constructor.height, ...[shapes, labels].map((group) => group.innerHTML.replace(/><\\/(?!text|tspan|svg)[a-z]+>/g, "/>").replace(/<tspan>(.*?)<\\/tspan>/g, "$1").replaceAll("/><", "/>\\n<").replaceAll("</text>", "</text>\\n"))];
})()"""


class Site(http.server.SimpleHTTPRequestHandler):
    """The figures and the engine."""

    def translate_path(self, path):
        return str((engine if path.endswith(".wasm") else live) / path.rsplit("/", 1)[-1])

    def log_message(self, *_):
        pass


def svg(title, height, shapes, labels):
    """The figure as a file. A color has its twin in a style sheet, for readers who prefer a dark page."""
    text = f"""<svg xmlns="http://www.w3.org/2000/svg" width="640" height="{height}" viewBox="0 0 640 {height}" role="img" \
font-family="sans-serif" font-size="14" stroke-linecap="round" stroke-linejoin="round">
<title>{escape(title)}</title>
<rect width="640" height="{height}" rx="8" fill="light-dark(#fff, #0d1117)"/>
{shapes}
<g fill="light-dark(#24292f, #e6edf3)" stroke="light-dark(#fff, #0d1117)" stroke-width="4" paint-order="stroke">
{labels}</g>
</svg>
""".replace(' xmlns="http://www.w3.org/2000/svg"><', "><")
    twins = sorted(set(re.findall(r'(fill|stroke)="light-dark\((.*?), (.*?)\)"', text)))
    style = "".join(f'[{name}="{light}"]{{{name}:{dark}}}' for name, light, dark in twins)
    text = re.sub(r"light-dark\((.*?), .*?\)", r"\1", text)
    return text.replace("</title>", f"</title>\n<style>@media (prefers-color-scheme:dark){{{style}}}</style>")


def main():
    if not chromium.program or not (engine / "engine_double.wasm").exists():
        print(f"skipped: {'the engine' if chromium.program else 'chromium'} is missing")
        sys.exit(77)
    server, origin = chromium.serve(Site)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        browser = chromium.Chromium(profile)
        try:
            browser.open(f"{origin}/mine.js")
            for name in sys.argv[4:] or titles:
                drawn = browser.run(draw % (name, name))
                (folder / f"{name}.svg").write_text(svg(titles[name], *drawn), encoding="utf-8", newline="\n")
        finally:
            browser.process.terminate()
            browser.process.wait()
    server.shutdown()


main()
