"""Makes the files of a finished site smaller; what a reader sees stays the same."""

import gzip
import json
import re
import string
from pathlib import Path

widest_picture = 1000  # pixels


def compress_pictures(site):
    """Pictures of scenes as WebP, a tenth as large, where Pillow is installed; those of the gallery
    no wider than they are seen. Who wants less motion gets the first picture of an animation. Returns
    the new names of what is seen at first."""
    try:
        from PIL import Image
    except ImportError:
        return {}
    still = {}
    for file in [*site.glob("pictures/**/*.png"), *site.glob("gallery/*.png"), *site.glob("accuracy/*.png")]:
        name = file.relative_to(site).as_posix()
        still[name] = name.replace(".png", ".webp")
        with Image.open(file) as picture:
            if getattr(picture, "is_animated", False):
                still[name] = name.replace(".png", "_still.webp")
                picture.save(file.with_suffix(".webp"), save_all=True, quality=85, method=6, loop=0,
                             duration=round(picture.info["duration"]))
                picture.seek(0)
            picture.thumbnail((widest_picture, widest_picture))
            picture.convert("RGB").save(site / still[name], quality=76)
        file.unlink()
    return still


def with_pictures(html, still):
    """A page with the new names of the pictures."""
    def image(found):
        before, start, name, behind = found.groups()
        if name not in still:
            return found[0]
        whole = name.replace(".png", ".webp")
        image = f'<img {before}src="{start}{whole}"{behind}>'
        if still[name] == whole:
            return image
        media = f'<source media="(prefers-reduced-motion: reduce)" srcset="{start}{still[name]}">'
        return f"<picture>{media}{image}</picture>"

    return re.sub(r'<img ([^>]*)src="((?:\.\./)*)([\w/]+\.png)"([^>]*?) ?/?>', image, html)


class Formulas:
    """KaTeX writes 80 bytes for a letter: in place of its names of classes and its styles, which are
    the same in all pages, formulas get classes of one or two letters, and KaTeX's style sheet too."""

    parts = '<span class="katex-mathml">', '<span class="katex-html" aria-hidden="true">'
    tag = re.compile(r'<(/?)span(?: class="([^"]*)")?(?: style="([^"]*)")?>')
    name = re.compile(r"\.([A-Za-z][\w-]*)")
    kept = {"katex", "katex-display"}

    def __init__(self, style_sheet):
        selectors = " ".join(re.findall(r"([^{}]*)\{", re.sub(r"@font-face\{.*?\}", "", style_sheet)))
        self.classes = {each: self.short(i) for i, each in enumerate(sorted({*self.name.findall(selectors)} - self.kept))}
        self.first_style, self.styles = len(self.classes), {}
        self.used = self.kept | {self.classes[part] for part in ("katex-mathml", "katex-html")}

        def renamed(found):  # a selector
            return self.name.sub(lambda each: "." + self.classes.get(each[1], each[1]), re.sub(r"\bspan\b", "i", found[0]))

        self.style_sheet = re.sub(r"(?<=[}])[^{}@]+(?=\{)", renamed, style_sheet)

    @staticmethod
    def short(number):
        letters = string.ascii_letters
        return letters[number] if number < 52 else letters[number // 52 - 1] + letters[number % 52]

    def shorter(self, found):
        is_end, names, style = found.groups()
        if is_end:
            return "</i>"
        classes = [self.classes[each] for each in (names or "").split() if each in self.classes]
        self.used.update(classes)
        if style:
            classes.append(self.styles.setdefault(style.strip(";"), self.short(self.first_style + len(self.styles))))
        quote = '"' if len(classes) > 1 else ""
        return f"<i class={quote}{' '.join(classes)}{quote}>" if classes else "<i>"

    def in_page(self, html):
        read, seen = self.parts
        page, *formulas = html.replace(read, f'<i class={self.classes["katex-mathml"]}>').replace("</math></span>", "</math></i>").split(seen)
        for formula in formulas:
            depth = 1
            for tag in self.tag.finditer(formula):
                depth += -1 if tag[1] else 1
                if depth == 0:
                    break
            page += f'<i class={self.classes["katex-html"]} aria-hidden=true>' + self.tag.sub(self.shorter, formula[:tag.end()]) + formula[tag.end():]
        return page

    def all_styles(self):
        """The style sheet, once all pages are done: what they need of it."""
        def is_used(rule):
            return any(set(self.name.findall(selector)) <= self.used for selector in rule.split("{")[0].split(","))

        rules = re.findall(r"[^{}]*\{[^{}]*\}", self.style_sheet)
        return ("".join(filter(is_used, rules)) + ".katex i{font-style:inherit}" +
                "".join(f".katex .{name}{{{style}}}" for style, name in self.styles.items()))


def shorter_drawing(drawn):
    """Parts that have the same pen one after the other as a group of it, and tenths of a pixel."""
    pen = re.compile(r' (?:fill|stroke(?:-\w+)?|class|clip-path)="[^"]*"')
    made, last = [], ""
    for line in drawn.splitlines():
        own = "".join(pen.findall(line)) if re.fullmatch(r"<\w+ [^<]*/>", line) else ""
        if own != last:
            made += ["</g>"] * bool(last) + [f"<g{own}>"] * bool(own)
        made.append(pen.sub("", line) if own else line)
        last = own
    return re.sub(r"(?<=[ \",A-Z-])(\d+\.\d)\d(?=[^<>]*/>)", r"\1", "\n".join(made))


def make_files_smaller(site, style_sheet):
    """Pages and figures, in all languages."""
    still = compress_pictures(site)
    formulas = Formulas(style_sheet.read_text(encoding="utf-8"))
    for page in site.rglob("*.html"):
        html = page.read_text(encoding="utf-8")
        page.write_text(formulas.in_page(with_pictures(html, still)), encoding="utf-8")
    for figure in site.rglob("*.svg"):
        figure.write_text(shorter_drawing(figure.read_text(encoding="utf-8")), encoding="utf-8")
    (site / "book/katex").mkdir(parents=True, exist_ok=True)
    (site / "book/katex/katex.min.css").write_text(formulas.all_styles(), encoding="utf-8")


def pack(content, target):
    """Writes a file that docs/figures/live/content.js unpacks."""
    target.write_bytes(gzip.compress(content, mtime=0))


def without_tex(text):
    """What a result shows of formulas: those in a line, without commands."""
    in_line = re.sub(r"\\\[.*?\\\]", "", text, flags=re.S)
    return re.sub(r"\\\((.*?)\\\)", lambda found: re.sub(r"\\[a-zA-Z]+ ?|[{}\\]", "", found[1]), in_line, flags=re.S)


def shorten_search_index(site):
    """A page's whole text is there again in its sections, which alone are searched. Known mistakes
    are found in their lists: they are half of the index, and nothing for students."""
    file = site / "search/search_index.json"
    index = json.loads(file.read_text(encoding="utf-8"))
    index["docs"] = [entry for entry in index["docs"] if not entry["location"].startswith("mistakes/")]
    places = [entry["location"] for entry in index["docs"]]
    with_sections = {place.split("#")[0] for place in places if "#" in place}
    for entry in index["docs"]:
        entry["text"] = "" if entry["location"] in with_sections else without_tex(entry["text"])
    file.write_text(json.dumps(index, ensure_ascii=False, separators=(",", ":")), encoding="utf-8")
