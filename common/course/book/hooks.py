"""Adds to the pages of the site the contracts, the hints, the errata and the figures that run, and
pages of the known mistakes. A hand-out, which has no tests/mistakes, gets none of those.

RAYSTEPS_SOURCE is where links to files beside docs/ lead: "../.." is the project's folder, as seen
from the site's, "https://github.com/NAME/raysteps/blob/main" a host. If it is empty, there are no
such links. RAYSTEPS_ENGINE is the folder with the figures' WebAssembly, if that is built.

The pages in another language (lang/) are in a folder of the site that has its name, which is built by
another run, in RAYSTEPS_LANGUAGE: it contains the pages that are translated, and leads to the English
site (links of the scheme english:) for everything else. A heading has the English anchor in all
languages; RAYSTEPS_ANCHORS is a file with them.
"""

import json
import os
import posixpath
import re
import shutil
import subprocess
import sys
import tempfile
from html import escape
from pathlib import Path

from mkdocs.exceptions import PluginError
from mkdocs.structure.files import File

here = Path(__file__).parent
project = here.parents[2]
live = project / "docs/figures/live"
engine = Path(os.environ.get("RAYSTEPS_ENGINE", live))
katex = Path("/usr/share/javascript/katex")
source = os.environ.get("RAYSTEPS_SOURCE", "../..")

meshes_in_pages = ["owl.off"]
scenes_in_pages = set()  # that can be drawn there
generated_pages = tempfile.TemporaryDirectory()

sys.path[:0] = [str(project / "lang"), str(here)]
from smaller import make_files_smaller, pack, shorten_search_index
try:
    import pages as translations
    languages = translations.languages() if translations.is_installed() else []
    others_need_po4a = translations.languages() != languages
except ImportError:  # a project without lang/
    translations, languages, others_need_po4a = None, [], False
language = os.environ.get("RAYSTEPS_LANGUAGE", "en")
is_english = language == "en"
tr = str if is_english else translations.words(language, "book")
texts = {} if is_english else translations.translated(language)

used_font = re.compile(r"KaTeX_(Main-Regular|Math-Italic|Size\d-Regular)\.woff2")

before_the_stages = ["debugging.md", "cpp.md"]
after_the_stages = ["README.md", "scenes.md", "your_own.md", "antialiasing.md", "glossary.md", "errata.md", "gallery.md"]


def text_of(path):
    return (project / path).read_text(encoding="utf-8")


def page_text(path):
    """A page in the language of the site, if it is translated."""
    return texts[path] if path in texts else text_of(path)


def first_heading(path):
    return re.search(r"(?m)^# (.*)$", text_of(path))[1]


def address_in_english(path):
    return f"english:{re.sub(r'[.]md(?=$|#)', '.html', path)}"


def set_language(config):
    """The words around the pages."""
    config["docs_dir"] = str(Path(generated_pages.name) / "docs")
    for path, text in texts.items():
        if path.startswith("docs/"):
            (Path(generated_pages.name) / path).parent.mkdir(exist_ok=True)
            (Path(generated_pages.name) / path).write_text(text, encoding="utf-8")
    for name, drawn in translations.translated_figures(language, texts).items():
        (Path(generated_pages.name) / "docs/figures").mkdir(exist_ok=True)
        (Path(generated_pages.name) / "docs/figures" / name).write_text(drawn, encoding="utf-8")
    config["theme"]["language"] = language
    config["plugins"]["search"].config["lang"] = [language]
    config["copyright"] = tr(config["copyright"])
    for palette in config["theme"]["palette"]:
        palette["toggle"]["name"] = tr(palette["toggle"]["name"])


def entry(page):
    """Of the navigation: the English page if it is not translated."""
    return page if f"docs/{page}" in texts else {first_heading(f"docs/{page}"): address_in_english(page)}


def on_config(config):
    if languages:
        config["extra"]["alternate"] = [{"name": "English", "link": "en", "lang": "en"}] + [
            {"name": translations.words(each, "book")("English"), "link": each, "lang": each} for each in languages]
    if not is_english:
        set_language(config)
    docs = project / "docs"
    stages = [*before_the_stages, *sorted(page.name for page in docs.glob("step*.md"))]
    others = sorted(sorted({page.name for page in docs.glob("*.md")} - set(stages)),
                    key=lambda name: [*after_the_stages, name].index(name))
    reference = sorted(f"reference/{page.name}" for page in docs.glob("reference/*.md"))
    if not is_english:
        stages, others, reference = (list(map(entry, part)) for part in (stages, others, reference))
    elif catalogues():
        reference.append("mistakes/index.md")  # which leads to one for each stage
    config["nav"] = [{tr("Home"): "index.md"}, {tr("Stages"): stages}, {tr("More"): others},
                     {tr("Reference"): reference}]
    return config


def on_files(files, config):
    """Of docs/, pages and pictures only. The home page is the project's README; that of docs/, whose
    name MkDocs takes for the home page's, is documents.html."""
    for file in list(files):
        in_docs = Path(file.abs_src_path).is_relative_to(config["docs_dir"])
        if in_docs and Path(file.src_path).suffix not in {".md", ".svg", ".png"}:
            files.remove(file)
    overview = files.get_file_from_path("README.md")
    overview.name = "documents"
    overview.dest_path = overview.url = "documents.html"
    overview.abs_dest_path = str(Path(config["site_dir"]) / overview.dest_path)
    generated = Path(generated_pages.name)
    home = re.sub(r"(?m)^\[English\]\(README\.md\).*\n\n", "", page_text("README.md"))  # the site has a switch
    home = re.sub(r"\]\((?!docs/|https?:|#)", "](../", home).replace("](docs/", "](")
    (generated / "index.md").write_text(home, encoding="utf-8")
    files.append(File("index.md", str(generated), config["site_dir"], False))
    if is_english and catalogues():
        write_mistakes(generated / "mistakes")
        for name in ["index", *catalogues()]:
            files.append(File(f"mistakes/{name}.md", str(generated), config["site_dir"], False))
    return files


# ---- known mistakes


record = re.compile(r"mistake (\w+) in (\S+)(?: around (.*))?\norigin: (.*)\ncaught by: (.*)\nsentence: (.*)\n((?:.*\n)*)")


def catalogues():
    return sorted(file.stem for file in (project / "tests/mistakes").glob("step*.txt") if "_trace" not in file.stem)


def mistakes_of(suite):
    file = project / f"tests/mistakes/{suite}.txt"
    text = file.read_text(encoding="utf-8") if file.exists() else ""
    return [record.fullmatch(part).groups() for part in re.split(r"(?m)^(?=mistake )", text)[1:]]


def source_of_origin(origin):
    """What the table of all stages counts."""
    if re.match(r"seen|common|a student's", origin):
        return "students"
    return "documents" if re.match(r"(MRT|M1|PHY|CR|HAI)\b", origin) else "derived"


def mistake_text(suite, mistake):
    name, right, around, origin, case, sentence, change = mistake
    stage = suite.removesuffix("_trace")
    files = {"main.cpp": f"steps/{stage}/main.cpp", "reference": f"steps/{stage}/reference/{stage[7:]}.cpp"}
    file = files.get(right, f"tests/alternatives/{suite}.cpp")
    calls = f", called around as <code>correct_{around}</code>" if around else ""
    return f"""### {name}

<p>{escape(sentence)}</p>

```diff
{change.strip(chr(10))}
```

<p class="origin">Origin: {escape(origin)}. Caught by: “{escape(case)}”.
Changes <a href="source:{file}"><code>{right}</code></a>{calls}.</p>

"""


def write_mistakes(folder):
    """A page for each stage, and one with their numbers."""
    folder.mkdir(exist_ok=True)
    rows = []
    for stage in catalogues():
        title = f"Stage {int(stage[4:6])}, {stage[7:].replace('_', ' ')}: known mistakes"
        page = f"# {title}\n\n"
        parts = [("In the functions", stage), ("In `main.cpp`", stage + "_trace")]
        for heading, suite in parts:
            if mistakes_of(suite):
                page += f"## {heading}: {len(mistakes_of(suite))}\n\n"
                page += "".join(mistake_text(suite, mistake) for mistake in mistakes_of(suite))
        (folder / f"{stage}.md").write_text(page, encoding="utf-8")
        counts = [len(mistakes_of(suite)) for _, suite in parts]
        origins = [source_of_origin(mistake[3]) for _, suite in parts for mistake in mistakes_of(suite)]
        rows.append((stage, *counts, *(origins.count(kind) for kind in ["documents", "students", "derived"])))
    total = ["all", *(sum(row[i] for row in rows) for i in range(1, 6))]
    table = "".join(f"| [{row[0]}]({row[0]}.md) | {' | '.join(map(str, row[1:]))} |\n" for row in rows)
    (folder / "index.md").write_text(f"""# Known mistakes

These {total[1] + total[2]} wrong answers are for lecturers: what students get wrong, and the sentence that tells them. Each stage's
suite must catch every one of its mistakes, by the case that is named. A mistake is shown as a change of a right answer.
[How the suites are tested](../reference/testing.md) explains them. The hand-out for students does not contain them.

| Stage | In its functions | In its `main.cpp` | From a document | Seen in students' code | Invented or derived |
|---|---|---|---|---|---|
{table}| {' | '.join(map(str, total))} |""", encoding="utf-8")


# ---- what is added to the text


def linked_to_sources(markdown, page, files):
    """Links out of docs/ become links of the scheme source:, as they have another start at the end;
    in another language, those to what is not translated become links of the scheme english:."""
    folder = posixpath.join("docs", posixpath.dirname(page.file.src_path))
    known = {file.src_path for file in files}

    def link(match):
        target, anchor = match.groups()
        path = posixpath.normpath(posixpath.join(folder, target))
        page_there = path.removeprefix("docs/")
        if page_there in known or re.match(r"\w+:", target):
            return match[0]
        if not is_english and path.startswith("docs/") and path.endswith((".md", ".svg", ".png")):
            return f"]({address_in_english(page_there + anchor)})"
        return f"](source:{path})" if target.startswith("../") else match[0]

    if catalogues():
        markdown = re.sub(r"\[`(\w+)`\]\((?:\.\./)+tests/mistakes/(step\w+?)(_trace)?\.txt\)",
                          lambda m: f"[`{m[1]}`]({'../' * page.file.src_path.count('/')}mistakes/{m[2]}.md#{m[1]})", markdown)
    return re.sub(r"\]\(([^)#\s]+)((?:#[^)\s]*)?)\)", link, markdown)


def contract(markdown):
    """The header that a stage's page names, behind the table of its functions."""
    header, table = re.search(r"`(steps/\S*\.hpp)`\s?:\n\n((?:\|.*\n)+)", markdown).groups()
    shown = f"""<details class="contract" markdown><summary>{tr("The contract:")} <code>{header}</code></summary>

```cpp
{text_of(header)}```

</details>

"""
    return markdown.replace(table, f"{table}\n{shown}", 1)


def hints(name):
    parts = re.split(r"^## \d\n", page_text(f"steps/{name}/hints.md"), flags=re.M)[1:]
    return f"## {tr('Hints')}\n\n" + "\n".join(
        f"<details markdown><summary>{tr('Hint')} {number}</summary>\n\n{part.strip()}\n\n</details>\n"
        for number, part in enumerate(parts, 1))


def errata(stage):
    """The rows of the errata's table that name the stage."""
    head, dashes, *rows = re.findall(r"^\|.*\|$", page_text("docs/errata.md"), flags=re.M)
    mine = [row for row in rows if str(stage) in re.split(r"[ ,|]+", row.rsplit(" | ", 1)[1])]
    if not mine:
        return ""
    table = "\n".join([head, dashes, *mine]).replace("](#", "](errata.md#")
    return f"### {tr('Errata of the documents')}\n\n{table}\n\n"


def before_heading(markdown, path, title, added):
    """Adds a text before the heading that has this title in the English page."""
    titles = [re.findall(r"(?m)^## (.*)$", text) for text in (text_of(path), page_text(path))]
    own = titles[1][titles[0].index(title)]
    return markdown.replace(f"\n## {own}\n", f"\n{added}## {own}\n", 1)


def on_page_markdown(markdown, page, config, files):
    stage = re.fullmatch(r"step(\d\d)_\w+\.md", page.file.src_path)
    if stage:
        markdown = contract(markdown)
        path = f"docs/{page.file.src_path}"
        markdown = before_heading(markdown, path, "What goes wrong", hints(page.file.name) + "\n")
        markdown = before_heading(markdown, path, "See it", errata(int(stage[1])))
    markdown = markdown.replace(f"<details><summary>{tr('For the curious')}",
                                f'<details class="curious"><summary>{tr("For the curious")}')
    markdown = re.sub(r"<details( class=\"curious\")?>", r"<details\1 markdown>", markdown)
    return linked_to_sources(markdown, page, files)


# ---- what is changed in the page


def to_root(page):
    """From a page to the start of the English site, which has what all languages need."""
    return "../" * (page.file.src_path.count("/") + (not is_english))


heading_anchor = re.compile(r'(?<=<h[1-6] id=")[^"]*')
english_anchors = {}
if not is_english:
    english_anchors = json.loads(Path(os.environ["RAYSTEPS_ANCHORS"]).read_text(encoding="utf-8"))


def with_english_anchors(html, page):
    own = heading_anchor.findall(html)
    path = page.file.src_path
    english = english_anchors.setdefault(path, own)
    if len(english) != len(own):
        raise PluginError(f"lang/{language}/docs/{path}: error: {len(own)} headings, not {len(english)} as in English")
    new = dict(zip(own, english))
    items = list(page.toc.items)
    for item in items:
        items += item.children
        item.id = new[item.id]
    return re.sub(r'(<h[1-6] id="|href="#)([^"]*)', lambda found: found[1] + new.get(found[2], found[2]), html)


def on_page_content(html, page, config, files):
    """A picture with a figure's name behind it is what is seen until the figure runs. The figure
    `picture` draws a scene of scenes/ with the program of the page's stage."""
    def figure(match):
        picture, name, scene = match.groups()
        needed = "picture_double.wasm" if scene else "engine_double.wasm"
        if not (live / f"{name}.js").exists() or not (engine / needed).exists():
            return picture
        if scene and not (project / "scenes" / scene).exists():  # in a hand-out
            return picture
        if scene:
            scenes_in_pages.add(scene)
        stage = f' stage="{int(page.file.name[4:6])}" scene="{scene}"' if scene else ""
        script = f'<script type="module" src="{to_root(page)}figures/{name}.js"></script>' if scene else ""
        return f"<rt-{name}{stage}>{picture}</rt-{name}>\n{script}"

    html = re.sub(r"(<p><img [^>]*></p>)\s*<!-- figure: ([\w-]+)(?: scenes/(\S+\.rt))? -->", figure, html)
    if page.file.src_path.startswith("mistakes/"):  # whose table of contents has a link to each
        html = re.sub(r'<a class="headerlink".*?</a>', "", html)
    html = with_english_anchors(html, page)
    headings = page.toc.items[0].children
    for heading in [*headings, *(below for heading in headings for below in heading.children)]:
        heading.title = re.sub(r"\\\((.*?)\\\)", r"\1", heading.title)  # formulas are not set there
    parts = [f'<a href="{heading.url}">{heading.title}</a>' for heading in headings]
    return html.replace("<h2", f'<p class="parts">{tr("In this page:")} {" · ".join(parts)}</p>\n<h2', 1)


class Typesetter:
    """KaTeX, in a process of node that gets a line of formulas and returns a line of HTML."""

    script = """
        const katex = require('%s/katex.js');
        const text = t => t.replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&');
        require('readline').createInterface({input: process.stdin}).on('line', line => {
            try {
                console.log(JSON.stringify(JSON.parse(line).map(([tex, displayMode]) =>
                    katex.renderToString(text(tex), {displayMode}).replace(/<annotation .*?<\\/annotation>|<\\/?semantics>| xmlns="[^"]*"/gs, '')
                    .replace(/(<math[^>]*>)<mrow>(.*)<\\/mrow>(?=<\\/math>)/s, '$1$2'))));
            } catch (error) { console.log(JSON.stringify(error.message)); }
        });
    """ % katex
    formula = re.compile(r'<(span|div) class="arithmatex">\\([\[(])(.*?)\\[\])]</\1>([.,;:)]?)', re.S)

    def __init__(self):
        self.node = subprocess.Popen(["node", "-e", self.script], text=True, encoding="utf-8",
                                     stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def typeset(self, html, page):
        formulas = [[tex, kind == "["] for _, kind, tex, _ in self.formula.findall(html)]
        self.node.stdin.write(json.dumps(formulas) + "\n")
        self.node.stdin.flush()
        done = json.loads(self.node.stdout.readline())
        if isinstance(done, str):
            raise PluginError(f"docs/{page.file.src_path}: error: {done}")

        def whole(match):
            tex, behind = match[3], match[4]
            return f'<span class="whole">{done.pop(0)}{behind}</span>' if len(tex) < 25 else done.pop(0) + behind

        return self.formula.sub(whole, html)

    def end(self):
        self.node.stdin.close()
        self.node.wait()


typesetter = None


def on_pre_build(config):
    global typesetter
    typesetter = Typesetter()


def with_breaks(html):
    """Where lines may end: not within an option or before a %, but within long names of inline code."""
    def code(found):
        if found[1] is None:
            return found[0].replace(" %", "&nbsp;%") if found[0].endswith(" %") else found[0]
        text = re.sub(r"(?<![\w-])--?[a-z][\w-]*", r'<span class="whole">\g<0></span>', found[1])
        if len(found[1]) > 12:
            text = re.sub(r"(?<=\w)[_/](?=\w)", r"\g<0><wbr>", text)
        return f"<code>{text}</code>"

    return re.sub(r"<pre.*?</pre>|<code>([^<]*)</code>|\d %", code, html, flags=re.S)


def with_joined_lines(html):
    """The lines of a change that are removed, or added, one after the other, are one part."""
    return re.sub(r'(?:<span class="(g[di])">[^<]*</span>\n)(?:<span class="\1">[^<]*</span>\n)+',
                  lambda found: f'<span class="{found[1]}">{re.sub("<[^>]*>", "", found[0])}</span>', html)


def with_legible_cells(html):
    """An empty cell is no header: a screen reader would call it one. A long one is not a word wide on a phone."""
    html = re.sub(r"<td>(?=[^<]{60})", '<td class="long">', html)
    html = re.sub(r"<thead>\s*<tr>(\s*<th[^>]*></th>)+\s*</tr>\s*</thead>", "", html)
    return re.sub(r"<th([^>]*)></th>", r"<td\1></td>", html)


def with_figures(head, article, page):
    """The head of a page begins with its figures, which run before the page is whole. It names what they load, and the fonts
    of formulas: browsers would find one in the other."""
    figures = list(dict.fromkeys(re.findall(r"<rt-(?!picture)(\w+)", article)))
    if not figures:
        return head
    root = to_root(page)
    imports = ";".join(f'await import("{root or "./"}figures/{name}.js")' for name in figures)
    links = [f"modulepreload href={root}figures/{name}.js" for name in [*figures, "drawing", "engine", "words", "content", "mine"]]
    links += [f"preload as=fetch crossorigin href={root}figures/{name}" for name in ["engine_double.wasm", *([] if is_english else [f"{language}.json"])]]
    links += [f"preload as=font crossorigin href={root}book/katex/fonts/KaTeX_{name}.woff2" for name in ["Main-Regular", "Math-Italic"]]
    return head.replace("<link", f"<script>(async()=>{{{imports}}})()</script>" + "".join(f"<link rel={link}>" for link in links) + "<link", 1)


def address_in(other, page):
    """The same page in another language, or the home page if it is not translated."""
    path = "README.md" if page.file.src_path == "index.md" else f"docs/{page.file.src_path}"
    is_there = other == "en" or translations.catalogue_of(path, other).exists()
    return to_root(page) + ("" if other == "en" else f"{other}/") + (page.url if is_there else "index.html")


def on_post_page(output, page, config):
    """Formulas are set here, after the index for searching is made, which has their text."""
    output = re.sub(r'href="[^"]*" hreflang="(\w+)"',
                    lambda found: f'href="{address_in(found[1], page)}" hreflang="{found[1]}"', output)
    if not is_english:
        output = re.sub(r'((?:href|src)=")english:', rf"\1{to_root(page)}", output)
        output = re.sub(r'"(?=(assets|book)/)', f'"{to_root(page)}', output)

    def link(match):
        path, label = match.groups()
        if not source or not (project / path).exists():  # a hand-out has no solutions
            return label
        start = to_root(page) if source.startswith("..") else ""
        is_folder = (project / path).is_dir()
        base = source.replace("/blob/", "/tree/") if is_folder else source
        return f'<a href="{start}{base}/{path}{"/" if is_folder else ""}">{label}</a>'

    output = re.sub(r'<a href="source:([^"]*)">(.*?)</a>', link, output, flags=re.S)
    head, article, foot = re.fullmatch(r"(.*?<article)(.*)(</article>.*)", output, flags=re.S).groups()
    head, foot = (re.sub(r'(?<=>)\n| xmlns="[^"]*"', "", re.sub(r"\s*\n\s*", "\n", part)) for part in (head, foot))
    # The headings are in the sidebar, and again among the pages, where phones show the links above the first heading.
    contents = head[head.rfind('<nav class="md-nav md-nav--secondary"'):head.rfind("</nav>")]
    if head.count(contents) == 2:
        head = re.sub(r'<input[^>]* id="__toc"><label class="md-nav__link.*?</label>', "", head.replace(contents + "</nav>", "", 1), flags=re.S)
    return with_figures(head, article, page) + typesetter.typeset(with_legible_cells(with_joined_lines(with_breaks(article))), page) + foot


def build_other_languages(site):
    anchors = Path(generated_pages.name) / "anchors.json"
    anchors.write_text(json.dumps(english_anchors), encoding="utf-8")
    for each in languages:
        subprocess.run([sys.executable, "-m", "mkdocs", "build", "--quiet", "--config-file", here / "mkdocs.yml", "--site-dir", site / each],
                       env={**os.environ, "RAYSTEPS_LANGUAGE": each, "RAYSTEPS_ANCHORS": str(anchors)}, check=True)
    if others_need_po4a:
        print("The pages are in English only: the other languages need po4a.", file=sys.stderr)


def remove_unused(site):
    """What is for a host whose name is known, for other languages, for debugging, and for browsers of before 2021."""
    if not is_english:
        shutil.rmtree(site / "assets")
    used = {"lunr.stemmer.support.min.js", *(f"lunr.{each}.min.js" for each in languages)}
    for unused in ["404.html", "sitemap.xml*", "assets/javascripts/lunr/**/*.js", "assets/**/*.map"]:
        for file in site.glob(unused):
            if not languages or file.name not in used:
                file.unlink()
    for style in site.glob("assets/stylesheets/*.css"):
        style.write_text(re.sub(r"[^{}]*:-(?:webkit|moz)-any\([^{}]*\{[^{}]*\}", "", style.read_text(encoding="utf-8")), encoding="utf-8")


def on_post_build(config):
    typesetter.end()
    site = Path(config["site_dir"])
    shorten_search_index(site)
    remove_unused(site)
    if not is_english:
        return
    build_other_languages(site)
    make_files_smaller(site, katex / "katex.min.css")
    (site / "book").mkdir(exist_ok=True)
    shutil.copy(here / "book.css", site / "book")
    shutil.copy(here / "language.js", site / "book")
    shutil.copytree(katex / "fonts", site / "book/katex/fonts",
                    ignore=lambda folder, names: [n for n in names if not used_font.fullmatch(n)])
    (site / "figures").mkdir(exist_ok=True)
    for script in live.glob("*.js"):
        (site / "figures" / script.name).write_text(re.sub(r"(?m)^ *(//.*\n)?", "", script.read_text(encoding="utf-8")), encoding="utf-8")
    for module in engine.glob("*.wasm"):
        pack(module.read_bytes(), site / "figures" / module.name)
    for each in languages:
        pack(json.dumps(translations.sentences_of_figures(each)).encode(), site / f"figures/{each}.json")
    meshes = [f"meshes/{name}" for name in meshes_in_pages if (project / "scenes/meshes" / name).exists()]
    for scene in [*scenes_in_pages, *(meshes if scenes_in_pages else [])]:
        (site / "figures/scenes" / scene).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(project / "scenes" / scene, site / "figures/scenes" / scene)
    for mesh in meshes if scenes_in_pages else []:
        pack((site / "figures/scenes" / mesh).read_bytes(), site / "figures/scenes" / mesh)
