"""Tests of the built site, without a browser: book_pages.py SITE PROJECT

Links and anchors, alternative texts, formulas, and what is taken from elsewhere while building: the
contract, the hints and the errata of each stage. Prints what is wrong.
"""

import re
import sys
from html import unescape
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlparse

site, project = (Path(argument).resolve() for argument in sys.argv[1:3])
errors = []


class Page(HTMLParser):
    """The links, anchors and texts of a page."""

    def __init__(self, path):
        super().__init__()
        self.path = path
        self.ids, self.links, self.loaded, self.text = set(), [], [], ""
        self.hidden = []  # the open elements whose text is code, or a formula's source
        self.formulas = self.pictures = 0
        self.feed(path.read_text(encoding="utf-8"))

    def fail(self, what):
        errors.append(f"{self.path.relative_to(site)}: {what}")

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if "id" in attributes:
            if attributes["id"] in self.ids and not attributes["id"].startswith("__"):
                self.fail(f"two elements are called {attributes['id']}")
            self.ids.add(attributes["id"])
        if tag in {"code", "script", "style", "annotation", "pre"}:
            self.hidden.append(tag)
        if tag == "a" and attributes.get("href"):
            self.links.append(attributes["href"])
        if tag in {"img", "script"} and attributes.get("src"):
            self.loaded.append(attributes["src"])
        if tag == "link" and attributes.get("rel") in {"stylesheet", "icon", "modulepreload", "preload"}:
            self.loaded.append(attributes["href"])
        if tag == "img":
            self.pictures += 1
            if not (attributes.get("alt") or "").strip():
                self.fail(f"{attributes['src']} has no alternative text")
        if attributes.get("class") == "katex":
            self.formulas += 1

    handle_startendtag = handle_starttag

    def handle_endtag(self, tag):
        if tag in self.hidden:
            self.hidden.remove(tag)

    def handle_data(self, data):
        if not self.hidden:
            self.text += data


pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}


def check_links(page):
    for link in page.links + page.loaded:
        address = urlparse(link)
        if address.scheme:
            if link in page.loaded or address.scheme not in {"http", "https"}:
                page.fail(f"{link} is of another host")
            continue
        target = (page.path.parent / unquote(address.path)).resolve() if address.path else page.path
        if not target.exists():
            page.fail(f"{link} leads nowhere")
        elif address.fragment and target in pages and unquote(address.fragment) not in pages[target].ids:
            page.fail(f"{link}: there is no such anchor")


def check_formulas(page):
    for unset in re.findall(r".{0,20}(?:\$|\\[\[(a-z]|arithmatex).{0,20}", page.text):
        page.fail(f"a formula is not set, or Markdown is left: {unset}")


def text_only(html):
    return unescape(re.sub(r"<[^>]*>", "", html))


def check_stage(number, page):
    """What the page does not contain in docs/."""
    name = page.path.stem
    header = project / f"steps/{name}/{name[7:]}.hpp"
    text = page.path.read_text(encoding="utf-8")
    if header.read_text(encoding="utf-8").strip() not in text_only(text):
        page.fail(f"does not show {header.name}")
    for level in (1, 2, 3):
        if f"<summary>Hint {level}</summary>" not in text:
            page.fail(f"does not show hint {level}")
    for row in re.findall(r"^\| \[(\d+)\].*\| ([\d, ]+) \|$", (project / "docs/errata.md").read_text("utf-8"), re.M):
        is_named = f'<td><a href="errata.html#erratum-{row[0]}">{row[0]}</a></td>' in text
        if is_named != (str(number) in row[1].split(", ")):
            page.fail(f"erratum {row[0]} is {'' if is_named else 'not '}in its table")


def check_captions(page):
    """Each figure that runs has its question below it."""
    caption = re.compile(r"</rt-(\w+)>\s*<script[^>]*></script>\s*(.*(?:\n(?!<).*)*)")
    for name, below in caption.findall(page.path.read_text(encoding="utf-8")):
        if name != "picture" and not re.match(r"<p><em>[^?]*\?", below):
            page.fail(f"the figure {name} has no caption with its question")


def paragraphs(path):
    """The paragraphs, items and cells that are sentences, without code and formulas."""
    html = re.sub(r"<(pre|code)\b.*?</\1>", "", path.read_text(encoding="utf-8").split("<h1")[1], flags=re.S)
    found = (" ".join(text_only(part).split()) for part in re.split(r"</?(?:p|li|td|h\d|summary)\b[^>]*>", html))
    verb = re.compile(r"\b(is|are|has|must|you|your|it|its|which|where|not)\b")  # no title has one
    return {text for text in found if len(re.findall(r"[a-z]{2,}", text)) > 5 and verb.search(text)}


def check_translation(path, is_whole):
    """The headings have the English anchors, and no sentence is English, once all pages are translated;
    but the glossary, which has the English terms."""
    english = site / path.name
    anchors = re.compile(r'<h[1-6] id="([^"]*)"')
    if anchors.findall(path.read_text("utf-8")) != anchors.findall(english.read_text("utf-8")):
        pages[path].fail(f"its anchors are not those of {english.name}")
    is_french = is_whole and path.name != "glossary.html"
    for same in paragraphs(path) & paragraphs(english) if is_french else []:
        pages[path].fail(f"is English: {same[:60]}")


def check_languages():
    for folder in project.glob("lang/*/docs"):
        translated = sorted((site / folder.parent.name).glob("*.html"))
        catalogues = [*folder.glob("*.po"), *folder.parent.glob("README.po")]
        if len(translated) != len(catalogues):
            errors.append(f"lang/{folder.parent.name}: {len(translated)} pages of {len(catalogues)} catalogues")
        pages_in_english = len([page for page in project.glob("docs/*.md") if page.name != "CHANGELOG.md"]) + 1
        for path in translated:
            check_translation(path, len(catalogues) == pages_in_english)


def check_size():
    size = sum(path.stat().st_size for path in site.rglob("*") if path.is_file())
    if size > 9e6 and not any(site.rglob("gallery/*.png")):  # which Pillow would have compressed
        errors.append(f"the site has {size} bytes")


for page in pages.values():
    check_links(page)
    check_formulas(page)
    check_captions(page)
stages = sorted(path for path in pages if path.parent == site and re.match(r"step\d\d_", path.name))
for number, path in enumerate(stages, 1):
    check_stage(number, pages[path])
check_languages()
check_size()
formulas = sum(page.formulas for page in pages.values())
links = sum(len(page.links) for page in pages.values())
if len(stages) < 13 or formulas < 800 or links < 1500:
    errors.append(f"{len(stages)} stages, {formulas} formulas, {links} links: fewer than there are")
print("\n".join(errors[:40]), end="\n" if errors else "")
sys.exit(bool(errors))
