#!/usr/bin/env python3
"""Screens of a terminal, one after the other, as an SVG: animate.py SCREEN... PICTURE

A screen is the output of `tmux capture-pane -e -p`, 80 × 24; the last one shows the picture, too.
"""
import base64
import html
import re
import sys

WIDTH, HEIGHT, LEFT, TOP = 8.4, 17, 12, 14  # of a character, and of the first one's corner
SECONDS = 4  # a screen
COLORS = {"31": "#ff7b72", "32": "#7ee787", "33": "#e3b341", "36": "#79c0ff", "2": "#8b949e"}


def spans(line):
    """The line as text in SVG: color and weight by its escape sequences."""
    color = weight = ""
    column = 0
    for codes, words in re.findall(r"(?:\x1b\[([\d;]*)m)?([^\x1b]*)", line):
        for code in codes.split(";") if codes else []:
            if code in ("", "0", "39", "22"):
                color, weight = ("" if code != "22" else color), ""
            elif code == "1":
                weight = ' font-weight="bold"'
            elif code in COLORS:
                color = f' fill="{COLORS[code]}"'
        if words.strip():
            start = LEFT + (column + len(words) - len(words.lstrip())) * WIDTH
            yield f'<tspan x="{start:.1f}"{color}{weight}>{html.escape(words.strip())}</tspan>'
        column += len(words)


def screen(number, count, text):
    first, last = 100 * number / count, 100 * (number + 1) / count
    steps = f"0%,{first:.3f}%{{opacity:0}}" if number else ""
    steps += f"{first + 0.001:.3f}%,{last:.3f}%{{opacity:1}}{last + 0.001:.3f}%,100%{{opacity:0}}"
    if number == count - 1:
        steps = f"0%,{first:.3f}%{{opacity:0}}{first + 0.001:.3f}%,100%{{opacity:1}}"
    rows = "\n".join(
        f'<text y="{TOP + (row + 1) * HEIGHT}">{"".join(spans(line))}</text>'
        for row, line in enumerate(text.split("\n")[:24]) if line.strip())
    style = f"@keyframes s{number}{{{steps}}}#s{number}{{animation:s{number} {count * SECONDS}s infinite}}"
    return style, f'<g id="s{number}">\n{rows}\n'


def main(screens, picture):
    width, height = 2 * LEFT + 80 * WIDTH, 2 * TOP + 24 * HEIGHT
    parts = [screen(number, len(screens), open(file, encoding="utf-8").read())
             for number, file in enumerate(screens)]
    image = base64.b64encode(open(picture, "rb").read()).decode()
    shown = (f'<image x="{width - 252:.0f}" y="{height - 192:.0f}" width="240" height="180" '
             f'href="data:image/png;base64,{image}"/>\n')
    print(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" '
          f'font-family="ui-monospace,DejaVu Sans Mono,Menlo,monospace" font-size="14" fill="#e6edf3">\n<title>./course watch 3</title>\n<style>'
          + "".join(style for style, _ in parts) +
          f'</style>\n<rect width="100%" height="100%" rx="8" fill="#0d1117"/>')
    for number, (_, group) in enumerate(parts):
        print(group + (shown if number == len(parts) - 1 else "") + "</g>")
    print("</svg>")


main(sys.argv[1:-1], sys.argv[-1])
