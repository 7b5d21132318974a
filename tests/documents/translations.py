"""The translations in lang/ against their sources: translations.py PROJECT

Each entry has the formulas, code, links and numbers of its English text, a word of docs/glossary.md for
each of its terms, and none of the words that lang/LANGUAGE/words.txt refuses. What it cites is as the
program prints it in that language. In a language that has words.txt at most 2 % of the entries are fuzzy
or not translated. Prints what is wrong.
"""

import html
import json
import re
import subprocess
import sys
from pathlib import Path

project = Path(sys.argv[1]).resolve()
sys.dont_write_bytecode = True
sys.path.insert(0, str(project / "lang"))
import pages

most_missing = 0.02
errors = []
string = re.compile(r'^(msgid|msgstr) ((?:"(?:[^"\\]|\\.)*"\n?)+)', re.M)


def entries(catalogue):
    """The flags, the text and its translation of each entry but the header."""
    blocks = [block for block in re.split(r"\n{2,}", catalogue.read_text(encoding="utf-8")) if "\nmsgid \"" in f"\n{block}"]
    for block in blocks[1:]:
        if re.search(r"(?m)^#~", block):
            continue
        text = {kind: "".join(map(json.loads, lines.strip().split("\n"))) for kind, lines in string.findall(block)}
        yield re.search(r"(?m)^#,.*fuzzy", block), text["msgid"], text["msgstr"]


def numbers(text):
    """A comma between digits is a point, and a blank between thousands is nothing."""
    found = re.findall(r"\d+(?:[.,\u00a0\u202f ]\d+)*", text)
    return sorted(re.sub(r"[.,\u00a0\u202f ]", "", number) for number in found)


def parts(text):
    formula, code, link = r"\$\$.*?\$\$|\$[^$]+\$", r"`[^`]+`", r"\]\([^)]+\)"
    formulas = [re.sub(r"\\text\{[^}]*\}", "", " ".join(each.split())) for each in re.findall(formula, text, re.S)]
    plain = re.sub(f"{formula}|{code}|{link}", "", text, flags=re.S)
    return {"formulas": sorted(formulas), "code": sorted(" ".join(each.split()) for each in re.findall(code, text)),
            "links": sorted(re.findall(link, text)), "numbers": numbers(plain),
            "places": sorted(set(re.findall(r"\{\w+\}", plain)))}


def refused_words(language):
    """Lines of lang/LANGUAGE/words.txt: a regular expression, two blanks, what is written instead."""
    file = pages.lang / language / "words.txt"
    lines = file.read_text(encoding="utf-8").splitlines() if file.exists() else []
    return [re.split(r"  +", line, 1) for line in lines if line and not line.startswith("#")]


def glossary():
    """By the English terms of docs/glossary.md that are phrases, and are phrases in the documents: the starts
    of the words of the documents."""
    rows = re.findall(r"(?m)^\| ([^|]+) \| ([^|,;:(]+)[^|]* \| ", (project / "docs/glossary.md").read_text(encoding="utf-8"))
    terms = {english.strip(): re.sub(r"\([^)]*\)", "", own) for own, english in rows[1:] if " " in english.strip()}
    return {english: [word[:5].lower() for word in re.findall(r"\b[^\W\d]{5,}", own)]
            for english, own in terms.items() if any(" " in each.strip() for each in own.split(","))}


def check_terms(where, english, own, terms):
    for term, starts in terms.items():
        if re.search(rf"\b{term}s?\b", english, re.I) and not any(start in own.lower() for start in [term.lower(), *starts]):
            errors.append(f"{where}: no word of the glossary for \"{term}\", {starts}: {own[:60]!r}")


def check_entry(where, english, own, refused):
    for what, of_english in parts(english).items():
        of_own = parts(own)[what]
        if of_english != of_own:
            errors.append(f"{where}: {what} {of_own}, not {of_english}: {own[:60]!r}")
    plain = re.sub(r"`[^`]*`|\]\([^)]*\)|(?m:^    .*$)|<!--.*?-->", "", own)
    label = re.match(r"\{?\w+\}?: ", own)  # a name, as in a hint
    if label and english.startswith(label[0]):
        plain = plain[label.end():]
    for word, instead in refused:
        found = re.search(word, plain, re.I | re.S)
        in_english = found and plain[max(found.start() - 5, 0):found.end()] in english  # as in a title
        if found and not (in_english and re.search(r"[^\W\d]", found[0])):
            errors.append(f"{where}: {found[0]!r}: {instead}: {plain[max(found.start() - 30, 0):found.end() + 10]!r}")


def label(sentence):
    """What a printed line begins with, before a colon or a value: "got:  {answer}" is known as "got"."""
    return re.split(r"[:{\u00a0]", sentence)[0].strip(" ().").lower()


def printed_labels(language):
    """How lines that are printed begin, in English, and in the language."""
    labels = {}
    for name in ["course", "program", "view"]:
        for english, own in pages.entries(language, name).items():
            labels.setdefault(label(english), set()).add(label(own))
    return labels


def check_citations(where, own, labels):
    """A word in italics, in bold or in « » is not what the program prints in English."""
    for cited in re.findall(r"\*([^*\n]+)\*|«\u00a0([^»\n]+)\u00a0»", own):
        printed = labels.get(label("".join(cited)))
        if printed and label("".join(cited)) not in printed:
            errors.append(f"{where}: {''.join(cited)!r} is printed as {sorted(printed)}: {own[:60]!r}")


def check_language(language):
    refused = refused_words(language)
    labels = printed_labels(language)
    terms = glossary() if language == "fr" else {}
    total = missing = 0
    for catalogue in sorted((pages.lang / language).rglob("*.po")):
        where = catalogue.relative_to(project).as_posix()
        right = subprocess.run(["msgfmt", "-c", "-o", "/dev/null", catalogue], text=True, stderr=subprocess.PIPE)
        if right.returncode:
            errors.append(f"{where}: {right.stderr}")
            continue
        for fuzzy, english, own in entries(catalogue):
            total += 1
            if fuzzy or not own:
                missing += 1
            else:
                check_entry(where, english, own, refused)
                check_terms(where, english, own, terms)
                check_citations(where, own, labels)
    print(f"{language}: {missing} of {total} entries are not translated")
    if refused and missing > most_missing * total:
        errors.append(f"lang/{language}: {missing} of {total} entries are fuzzy or not translated: at most {most_missing:.0%}")


def check_headings(language):
    """A translated page has the headings of the English one, whose anchors it gets."""
    for page, text in pages.translated(language).items():
        english = pages.headings((project / page).read_text(encoding="utf-8"))
        if len(english) != len(pages.headings(text)):
            errors.append(f"lang/{language}: {page}: other headings than in English")


def check_figures(language):
    """Each label of a drawn figure with a word, which is not a name of the code, is translated, by its own entry if it has one."""
    name = r"cos\S*|tan|pix\w+|\w+_\w+"
    entries = {re.sub(r"[$_]", "", english): re.sub(r"[$_]", "", own) for english, own in pages.entries(language, "figures").items()}
    known = [re.compile(re.sub(r"\\{\w+\\}", ".+?", re.escape(text))) for text in entries]
    translated = pages.translated_figures(language, {})

    def labels(drawn):
        return [html.unescape(re.sub(r"<[^>]*>", "", label)) for label in re.findall(r"<text[^>]*>(.*?)</text>", drawn, re.S)]

    for figure in sorted(project.glob("docs/figures/*.svg")):
        for text, own in zip(labels(figure.read_text(encoding="utf-8")), labels(translated[figure.name])):
            if own != entries.get(text, own):
                errors.append(f"lang/{language}/figures.po: {text!r} of {figure.name} is {own!r}, and not {entries[text]!r}")
            if re.search(rf"\b(?!(?:{name})\b)[a-z]{{3,}}", text) and not any(each.fullmatch(text) for each in known):
                errors.append(f"lang/{language}/figures.po: nothing for {text!r} of {figure.name}: see docs/figures/printed.txt")


def check_all():
    for language in pages.languages():
        check_language(language)
        check_headings(language)
        if refused_words(language):
            check_figures(language)
        kept = project / f"README.{language}.md"
        if kept.exists() and kept.read_text(encoding="utf-8") != pages.readme(language):
            errors.append(f"{kept.name} is not what lang/pages.py {language} writes")


if __name__ == "__main__":
    check_all()
    print("\n".join(errors), end="\n" if errors else "")
    sys.exit(bool(errors))
