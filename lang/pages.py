#!/usr/bin/env python3
"""The pages and sentences in other languages: lang/pages.py LANGUAGE… or --in-place LANGUAGE

A page P.md is translated by lang/LANGUAGE/P.po, by po4a, and a stage's hints by the catalogue of its page;
what ./course prints by course.po, and a stage's cases and known mistakes by steps/STAGE/sentences.po. The command brings these files up to date
with the English texts, prints what is to be translated, and writes README.LANGUAGE.md, the only
translated page that is kept. The book (common/course/book) and its tests use the functions. With --in-place
it replaces the English pages, as in a hand-out in that language.
docs/reference/translating.md is for translators.
"""

import gettext
import html
import io
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

project = Path(__file__).resolve().parents[1]
lang = project / "lang"

po4a = """
    use Locale::Po4a::Chooser;
    while (my ($page, $catalogue, $made) = splice @ARGV, 0, 3) {
        my $text = Locale::Po4a::Chooser::new("text", markdown => 1, neverwrap => 1);
        $text->process(po_in_name => $catalogue ? [$catalogue] : [], file_in_name => [$page],
                       file_in_charset => "UTF-8", file_out_charset => "UTF-8");
        $catalogue ? $text->write($made) : $text->writepo($made);
    }
"""


def run_po4a(*arguments):
    """Translates by triples: page, catalogue, translated page; without a catalogue it makes a template."""
    subprocess.run(["perl", "-e", po4a, *arguments], check=True, stdout=subprocess.DEVNULL)


def languages():
    return sorted(folder.name for folder in lang.iterdir() if (folder / "book.po").exists())


def is_installed():
    return bool(shutil.which("po4a"))


def pages():
    """The pages to translate, by their paths in the project."""
    docs = sorted(page for page in project.glob("docs/*.md") if page.name != "CHANGELOG.md")
    found = [project / "README.md", *docs, *sorted(project.glob("steps/*/hints.md"))]
    return [page.relative_to(project).as_posix() for page in found]


def catalogue_of(page, language):
    page = re.sub(r"^steps/(\w+)/hints\.md$", r"docs/\1.md", page)
    return lang / language / Path(page).with_suffix(".po")


def entries(language, name):
    """The translations in lang/LANGUAGE/NAME.po by their English texts; what is fuzzy is left out."""
    catalogue = lang / language / f"{name}.po"
    if not catalogue.exists():
        return {}
    made = subprocess.run(["msgfmt", "-o", "-", catalogue], stdout=subprocess.PIPE, check=True).stdout
    return {english: own for english, own in gettext.GNUTranslations(io.BytesIO(made))._catalog.items() if english}


def words(language, name):
    """The translation of a word in lang/LANGUAGE/NAME.po, as a function."""
    known = entries(language, name)
    return lambda english: known.get(english, english)


def sentences_of_figures(language):
    """What stands in figures that run: also what they get from the stages' programs."""
    return {**entries(language, "course"), **entries(language, "program"), **entries(language, "figures")}


def typeset(label):
    """The text of an SVG file: between two $, "_" lowers the next letter, and a letter is italic."""
    made, low = "", 0
    for number, part in enumerate(label.split("$")):
        for piece in re.findall(r"_.|[^\W\d_]|(?:[^\w_]|\d)+" if number % 2 else r".+", part, re.S):
            lowered = number % 2 and piece.startswith("_")
            dy, piece = (4 if lowered else 0) - low, piece[1:] if lowered else piece
            low += dy
            italic = ' font-style="italic"' if number % 2 and piece.isalpha() else ""
            style = italic + (' font-size="75%"' if lowered else "") + (f' dy="{dy}"' if dy else "")
            made += f"<tspan{style}>{html.escape(piece, quote=False)}</tspan>" if style else html.escape(piece, quote=False)
    return made


def translated_figures(language, texts):
    """The drawn figures of docs/figures by their names, with translated labels, and the title that the page has."""
    def words_of(each):  # a text without places is nearer than one with places, as in words.js
        words = re.sub(r"{\w+}", "", each[0])
        return words != each[0], -len(words)

    patterns = []
    for english, own in sorted(entries(language, "figures").items(), key=words_of):
        plain = re.escape(re.sub(r"[$_]", "", english)).replace(r"\{", "{").replace(r"\}", "}")
        patterns.append((re.compile(re.sub(r"{(\w+)}", r"(?P<\1>.+?)", plain)), own))

    def label(found):
        text = html.unescape(re.sub(r"<[^>]*>", "", found[2]))
        for english, own in patterns:
            if values := english.fullmatch(text):
                return f"{found[1]}{typeset(own.format(**values.groupdict()))}</text>"
        return found[0]

    titles = {name: title for text in texts.values() for title, name in re.findall(r"!\[([^\]]*)\]\(figures/(\w+)\.svg\)", text)}
    figures = {}
    for file in sorted(project.glob("docs/figures/*.svg")):
        drawn = re.sub(r"(<text[^>]*>)(.*?)</text>", label, file.read_text(encoding="utf-8"), flags=re.S)
        title = html.escape(titles.get(file.stem, ""), quote=False)
        figures[file.name] = re.sub(r"<title>.*?</title>", lambda _: f"<title>{title}</title>", drawn) if title else drawn
    return figures


def tight(markdown):
    """Without the blank lines that po4a puts between the items of a list, none of which has one."""
    item = r"(?:- |\d+\. )"
    before = None
    while before != markdown:
        before = markdown
        markdown = re.sub(rf"(?m)^( *{item}.*\n(?: +\S.*\n)*)\n+(?= *{item})", r"\1", markdown)
    return re.sub(r"\n{3,}", "\n\n", markdown).rstrip("\n") + "\n"


def translated(language):
    """The text of each page that has a catalogue. Paragraphs without a translation are in English."""
    with tempfile.TemporaryDirectory() as folder:
        made = {page: Path(folder) / str(number) for number, page in enumerate(pages())
                if catalogue_of(page, language).exists()}
        arguments = [name for page, to in made.items()
                     for name in (project / page, catalogue_of(page, language), to)]
        run_po4a(*arguments)
        return {page: tight(to.read_text(encoding="utf-8")) for page, to in made.items()}


def headings(markdown):
    """The headings of a page, without those in code."""
    text = re.sub(r"(?ms)^```.*?^```$", "", markdown)
    return re.findall(r"(?m)^#+ (.*)$", text)


def anchor_of(heading):
    return re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-")


def with_english_anchors(english, own, linked):
    """A page with the anchors of the English one, so far as they are linked, beside its own."""
    titles = dict(zip(headings(own), headings(english)))

    def anchored(heading):
        anchor = anchor_of(titles.get(heading[1], heading[1]))
        needs_it = anchor in linked and anchor != anchor_of(heading[1])
        return f'<a id="{anchor}"></a>\n\n{heading[0]}' if needs_it else heading[0]

    return re.sub(r"(?m)^#+ (.*)$", anchored, own)


def anchors_in(markdown):
    return set(re.findall(r"\]\([^)#\s]*#([^)\s]+)\)", markdown))


def readme(language):
    """The README as GitHub shows it: the English anchors, to which its links lead, lead there too."""
    markdown = translated(language)["README.md"]
    return with_english_anchors((project / "README.md").read_text(encoding="utf-8"), markdown, anchors_in(markdown))


def replace_pages(language):
    """The pages take the place of the English ones, and ./course speaks their language too."""
    texts = translated(language)
    texts["README.md"] = re.sub(r"(?m)^\[English\]\(README\.md\).*\n\n", "", texts["README.md"])
    linked = set().union(*(anchors_in(page.read_text(encoding="utf-8")) for page in project.rglob("*.md")))
    for page, text in texts.items():
        english = (project / page).read_text(encoding="utf-8")
        (project / page).write_text(with_english_anchors(english, text, linked), encoding="utf-8")
        catalogue_of(page, language).unlink(missing_ok=True)
    for name, drawn in translated_figures(language, texts).items():
        (project / "docs/figures" / name).write_text(drawn, encoding="utf-8")
    for kept in project.glob("README.*.md"):
        kept.unlink()
    (lang / "default.txt").write_text(f"{language}\n", encoding="utf-8")


header = '''msgid ""
msgstr ""
"Language: {language}\\n"
"MIME-Version: 1.0\\n"
"Content-Type: text/plain; charset=UTF-8\\n"
"Content-Transfer-Encoding: 8bit\\n"

'''


def merge(catalogue, template, language):
    """Takes the entries of a template into a catalogue, new ones without a translation."""
    catalogue.parent.mkdir(parents=True, exist_ok=True)
    if catalogue.exists() and catalogue.stat().st_size > 0:
        subprocess.run(["msgmerge", "--quiet", "--update", "--backup=none", "--no-wrap", "--previous", catalogue,
                        template], check=True)
    else:
        shutil.copy(template, catalogue)
    entries = catalogue.read_text(encoding="utf-8").split("\n\n", 1)[1]
    entries = re.sub(r"(?m)^#: .*\n", "", entries)  # lines of the page, which change with every change
    catalogue.write_text(header.format(language=language) + entries, encoding="utf-8")


def report(catalogue):
    """Prints how many entries are to be translated."""
    for kind in ["--only-fuzzy", "--untranslated"]:
        found = subprocess.run(["msgattrib", "--no-obsolete", kind, catalogue], check=True, text=True,
                               encoding="utf-8", stdout=subprocess.PIPE).stdout
        count = found.count("\nmsgid ")
        if count > 0:
            print(f"{catalogue.relative_to(project)}: {count} {kind.rpartition('-')[2]}")


rooms = {"course": "common/course", "grading": "common/course/grade", "program": "common/program", "view": "common/course/view",
         "figures": "docs/figures"}


def write_messages(template, name):
    """What ./course prints (course), or writes about grades (grading), with the arguments of tr and to_translate
    and the descriptions of commands and options; what a stage's program prints, what the page of ./course
    view has, and what stands in figures. False if there is no such source."""
    room = project / rooms[name]
    of_student = re.compile(r"\b(tr|to_translate|add_student_commands|add_author_commands)\(")
    of_code = name in ["course", "grading", "program"]
    shared = (project / "common/system").glob("*.?pp" if name == "course" else "translated_help.hpp")
    sources = [source for source in sorted([*room.glob("**/*.?pp"), *shared]) if of_code
               and (name == "grading" or "grade" not in source.relative_to(project).parts)
               and of_student.search(source.read_text(encoding="utf-8"))]
    sentences = sentences_elsewhere(room, name)
    if not sources + sentences:  # the book without the program
        return False
    template.write_text(header.format(language=""), encoding="utf-8")
    if sources:
        keywords = ["tr", "to_translate", "add:2", "add_of_stage:2", "add_of_program:2", "add_option:3", "add_flag:3",
                    "add_number:5", "add_choice:6", "add_whole:3"]
        subprocess.run(["xgettext", "--from-code=UTF-8", "--language=C++", "--no-location", "--no-wrap",
                        "--keyword", *(f"--keyword={word}" for word in keywords), "-o", template, *sources], check=True)
    text = template.read_text(encoding="utf-8").replace("charset=CHARSET", "charset=UTF-8")
    text = text.replace("#, c-format\n", "")  # a guess, by a percent sign
    for sentence in sentences:
        entry = f"\nmsgid {json.dumps(sentence, ensure_ascii=False)}\nmsgstr \"\"\n"
        text += "" if entry in text else entry
    template.write_text(text, encoding="utf-8")
    return True


def sentences_elsewhere(room, name):
    """Those of printed.txt, which others put together, as suites and stages' programs; for the script course, the
    arguments of its functions text and fail; for a page, its words and the arguments of tr."""
    script, printed = project / "course", room / "printed.txt"
    found = []
    if name == "course" and script.exists():
        found += re.findall(r'\b(?:text|fail) "([^"$]+)"', script.read_text(encoding="utf-8"))
    if name == "view":
        for page in [*room.glob("*.html"), *sorted(room.glob("*.js"))]:
            text = page.read_text(encoding="utf-8")
            words = r'\btr\("([^"]+)"' if page.suffix == ".js" else r'>([^<>]*[a-z]{2}[^<>]*)(?=<)|(?:aria-label|title)="([^"]+)"'
            found += [" ".join(word.split()) for groups in re.findall(words, text)
                      for word in ([groups] if isinstance(groups, str) else groups) if word]
    if printed.exists():
        found += [line for line in printed.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    return found


def sentences_of(stage):
    """The names of a stage's cases, without the parts before a colon, and its known mistakes."""
    found = []
    for suite in sorted([*project.glob(f"tests/suites/{stage}*_test.cpp"), *project.glob(f"tests/suites/{stage}/*.cpp")]):
        for name in re.findall(r'TEST_CASE\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)', suite.read_text(encoding="utf-8")):
            found.append("".join(json.loads(part) for part in re.findall(r'"(?:[^"\\]|\\.)*"', name)))
        found += [part for part in re.findall(r"\[part ([^\]]+)\]", suite.read_text(encoding="utf-8"))
                  if not re.fullmatch(r"\w+|together", part) or part == "together"]
    for mistakes in sorted(project.glob(f"tests/mistakes/{stage}*.txt")):
        found += re.findall(r"(?m)^sentence: (.*)$", mistakes.read_text(encoding="utf-8"))
    return list(dict.fromkeys(found))


def write_sentences(template, stage):
    entries = [f"msgid {json.dumps(each, ensure_ascii=False)}\nmsgstr \"\"\n" for each in sentences_of(stage)]
    template.write_text(header.format(language="") + "\n".join(entries), encoding="utf-8")


def update(language):
    with tempfile.TemporaryDirectory() as folder:
        template = Path(folder) / "template.pot"
        templates = {}
        for number, page in enumerate(pages()):
            run_po4a(project / page, "", Path(folder) / str(number))
            templates.setdefault(catalogue_of(page, language), []).append(Path(folder) / str(number))
        for catalogue, of_pages in templates.items():
            subprocess.run(["msgcat", "--no-wrap", "--use-first", "-o", template, *of_pages], check=True)
            merge(catalogue, template, language)
        for name in rooms:
            if write_messages(template, name):
                merge(lang / language / f"{name}.po", template, language)
        for sentences in (lang / language).glob("steps/*/sentences.po"):  # an empty file begins one
            write_sentences(template, sentences.parent.name)
            merge(sentences, template, language)
    for catalogue in sorted((lang / language).rglob("*.po")):
        report(catalogue)
    text = readme(language)
    (project / f"README.{language}.md").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    in_place = sys.argv[1:2] == ["--in-place"]
    for each in sys.argv[1 + in_place:]:
        if not re.fullmatch(r"[a-z]{2,3}(_[A-Z]{2})?", each):
            sys.exit(f"error: {each!r} is no language, as fr is: lang/pages.py LANGUAGE…")
        replace_pages(each) if in_place else update(each)
