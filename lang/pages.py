#!/usr/bin/env python3
"""The pages and sentences in other languages: lang/pages.py LANGUAGE…

A page P.md is translated by lang/LANGUAGE/P.po, by po4a; what ./course prints by course.po, and a
stage's cases and known mistakes by steps/STAGE/sentences.po. The command brings these files up to date
with the English texts, prints what is to be translated, and writes README.LANGUAGE.md, the only
translated page that is kept. The book (common/course/book) and its tests use the functions.
docs/reference/translating.md is for translators.
"""

import gettext
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
    return lang / language / Path(page).with_suffix(".po")


def words(language, name):
    """The translation of a word in lang/LANGUAGE/NAME.po, as a function."""
    catalogue = lang / language / f"{name}.po"
    if not catalogue.exists():
        return str
    made = subprocess.run(["msgfmt", "-o", "-", catalogue], stdout=subprocess.PIPE, check=True).stdout
    return gettext.GNUTranslations(io.BytesIO(made)).gettext


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


def readme(language):
    """The README as GitHub shows it: the English anchors, to which its links lead, lead there too."""
    english = (project / "README.md").read_text(encoding="utf-8")
    markdown = translated(language)["README.md"]
    for title, own in zip(headings(english), headings(markdown)):
        anchor = re.sub(r"[^\w -]", "", title.lower()).replace(" ", "-")
        if f"(#{anchor})" in markdown:
            markdown = re.sub(rf"(?m)^(#+ {re.escape(own)})$", rf'<a id="{anchor}"></a>\n\n\1', markdown)
    return markdown


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


def write_messages(template, name):
    """What ./course prints (course), or writes about grades (grading): the arguments of tr and to_translate,
    the descriptions of commands and options, the sentences of its script, and of printed.txt. False if
    there is no such source."""
    room = project / ("common/course/grade" if name == "grading" else "common/course")
    of_student = re.compile(r"\b(tr|to_translate|add_student_commands|add_author_commands)\(")
    sources = [source for source in sorted(room.glob("**/*.?pp"))
               if (name == "grading" or "grade" not in source.relative_to(room).parts)
               and of_student.search(source.read_text(encoding="utf-8"))]
    if not sources:  # the book without the program
        return False
    keywords = ["tr", "to_translate", "add:2", "add_of_stage:2", "add_of_program:2", "add_option:3", "add_flag:3"]
    subprocess.run(["xgettext", "--from-code=UTF-8", "--language=C++", "--no-location", "--no-wrap",
                    "--keyword", *(f"--keyword={word}" for word in keywords), "-o", template, *sources], check=True)
    text = template.read_text(encoding="utf-8").replace("charset=CHARSET", "charset=UTF-8")
    text = text.replace("#, c-format\n", "")  # a guess, by a percent sign
    for sentence in (sentences_of_script() if name == "course" else []) + sentences_elsewhere(room):
        entry = f"\nmsgid {json.dumps(sentence, ensure_ascii=False)}\nmsgstr \"\"\n"
        text += "" if entry in text else entry
    template.write_text(text, encoding="utf-8")
    return True


def sentences_of_script():
    """The arguments of its functions text and fail."""
    script = project / "course"
    return re.findall(r'\b(?:text|fail) "([^"$]+)"', script.read_text(encoding="utf-8")) if script.exists() else []


def sentences_elsewhere(room):
    """Those of printed.txt: what others put together, as suites and stages' programs."""
    lines = (room / "printed.txt").read_text(encoding="utf-8").splitlines()
    return [line for line in lines if line and not line.startswith("#")]


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
        for page in pages():
            run_po4a(project / page, "", template)
            merge(catalogue_of(page, language), template, language)
        for name in ["course", "grading"]:
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
    for each in sys.argv[1:]:
        if not re.fullmatch(r"[a-z]{2,3}(_[A-Z]{2})?", each):
            sys.exit(f"error: {each!r} is no language, as fr is: lang/pages.py LANGUAGE…")
        update(each)
