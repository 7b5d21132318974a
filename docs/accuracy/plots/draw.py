#!/usr/bin/env python3
"""The tables of accuracy*.md and the plots beside them, from the CSV of `./course measure`.

draw.py                writes them
draw.py ready          fails if matplotlib is missing
draw.py check-tables   fails if the page's are not what the CSV gives
draw.py check-plots    the same of the plots: by their words and points, since every version of
                       matplotlib draws with other bytes; 77 if matplotlib is missing

Each module of plots has a function plots(), which yields names, titles and figures.
"""
import importlib
import importlib.util
import os
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True
from data import FOLDER  # noqa: E402
from tables import tables  # noqa: E402

SYSTEM = "/usr/bin/python3"  # has modules that the first Python in the PATH may lack
PLOTS = ["shapes", "studies", "settings"]
MISSING = "this needs matplotlib: python3-matplotlib, or what your system calls it"


def is_there(module):
    """True if it is; otherwise the program starts again in the system's Python, or this is it."""
    if importlib.util.find_spec(module) is not None:
        return True
    if Path(SYSTEM).exists() and not os.path.samefile(SYSTEM, sys.executable):
        os.execv(SYSTEM, [SYSTEM, *sys.argv])
    return False


def pages():
    """The text of each page that has tables, wherever among the pages it is."""
    return {file: file.read_text("utf-8") for file in sorted(FOLDER.parent.rglob("accuracy*.md"))}


def pages_with_tables(texts):
    texts = dict(texts)
    for name, table in tables().items():
        begin, end = f"<!-- table {name} -->\n", f"<!-- end of {name} -->\n"
        places = [file for file, text in texts.items() if begin in text and end in text]
        if len(places) != 1:
            sys.exit(f"error: expected one place for the table {name}, not {len(places)}")
        text = texts[places[0]]
        texts[places[0]] = text[:text.index(begin) + len(begin)] + table + text[text.index(end):]
    return texts


def plots():
    """Names, titles and figures."""
    for module in PLOTS:
        yield from importlib.import_module(module).plots()


def content_of(source):
    return "".join(re.findall(r"<!-- content (\w+) -->", source))


def write():
    for file, text in pages_with_tables(pages()).items():
        file.write_text(text, "utf-8")
    from style import svg
    for name, title, figure in plots():
        (FOLDER / f"{name}.svg").write_text(svg(title, figure), "utf-8")


def check_tables():
    texts = pages()
    stale = [file.name for file, text in pages_with_tables(texts).items() if text != texts[file]]
    if stale:
        sys.exit(f"other tables than the CSV files give: {', '.join(stale)}: run {__file__}")


def check_plots():
    from style import content
    committed = {file.stem: content_of(file.read_text("utf-8")) for file in FOLDER.glob("*.svg")}
    drawn = {name: content(title, figure) for name, title, figure in plots()}
    stale = [name for name in {**drawn, **committed} if drawn.get(name) != committed.get(name)]
    if stale:
        sys.exit(f"not what the CSV files give: {', '.join(stale)}: run {__file__}")


def main(command):
    if command == "check-tables":
        return check_tables()
    if not is_there("matplotlib"):
        print(MISSING, file=sys.stderr)
        return 77 if command == "check-plots" else 2
    commands = {"": write, "ready": lambda: None, "check-plots": check_plots}
    return commands[command]()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else ""))
