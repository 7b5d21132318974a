"""The style of all plots: colors, dashes, markers, tiles, and how an SVG is written.

Series are distinguished by color, dash and marker at once. The colors are those of Okabe and Ito
(2008), which readers with any of the common color deficiencies tell apart. An SVG brings a card of
its own, white, or dark where the reader prefers dark; both suit the colors.
"""
import hashlib
import io
import re

import matplotlib

from words import exponent

matplotlib.use("svg")
from matplotlib import pyplot, ticker  # noqa: E402

INK, GRAY, FAINT, CARD = "#24292f", "#68707a", "#d3d9e0", "#ffffff"
BLUE, VERMILION, GREEN, PURPLE = "#0072b2", "#d55e00", "#009e73", "#cc79a7"
DARK = {INK: "#e6edf3", GRAY: "#9da7b3", FAINT: "#3b434d", CARD: "#0d1117",
        BLUE: "#3d9fdc"}  # of the series, the only one too dark for a dark card

# The color, dashes and marker of each series.
SERIES = [
    dict(color=VERMILION, linestyle=(0, (5, 2)), marker="s"),
    dict(color=BLUE, linestyle="-", marker="o"),
    dict(color=GREEN, linestyle=(0, (1, 1.5)), marker="^"),
    dict(color=PURPLE, linestyle=(0, (6, 2, 1, 2)), marker="D"),
]
FLOAT = dict(SERIES[0], markerfacecolor=CARD)
DOUBLE = SERIES[1]

# Shares of rays in five steps; "few" is below the first.
STEPS = [(1, "#fde6cf"), (5, "#fdc38d"), (20, "#f08c3e"), (50, "#c8541a"), (101, "#7f2704")]
ON_LIGHT, ON_DARK = "#1f2328", "#fffffe"  # words on a tile, on either card
FEW = 5  # rays or pixels: fewer may be chance, and are counted, not drawn

ENLARGED = 1.25  # pixels of the SVG, of one of the figure

pyplot.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "raysteps",
    "font.family": "sans-serif", "font.sans-serif": ["DejaVu Sans", "Verdana", "sans-serif"],
    "font.size": 9, "axes.titlesize": 10, "axes.titleweight": "bold", "axes.titlelocation": "left",
    "figure.facecolor": CARD, "axes.facecolor": CARD, "text.color": INK, "axes.labelcolor": INK,
    "axes.edgecolor": FAINT, "xtick.color": FAINT, "ytick.color": FAINT,
    "xtick.labelcolor": INK, "ytick.labelcolor": INK, "axes.grid": True, "grid.color": FAINT,
    "grid.linewidth": 0.6, "axes.spines.top": False, "axes.spines.right": False,
    "axes.axisbelow": True, "lines.linewidth": 1.6, "lines.markersize": 5,
    "legend.frameon": True, "legend.framealpha": 1, "legend.facecolor": CARD,
    "figure.max_open_warning": 0,  # draw.py check-plots opens all
    "legend.edgecolor": FAINT, "legend.handlelength": 3.5, "axes.unicode_minus": True,
})


def figure(width, height, panels=1, rows=1, **options):
    """A figure of width × height pixels at ordinary size: `panels` side by side, in `rows`."""
    fig, axes = pyplot.subplots(rows, panels, figsize=(width / 72, height / 72),
                                layout="constrained", **options)
    fig.get_layout_engine().set(w_pad=0.12, h_pad=0.1)
    return fig, axes


def tens(value):
    """10⁻⁶."""
    return {0: "1", 1: "10"}.get(value, "10" + exponent(value))


def decades(axis, first, last, step):
    """Ticks at powers of ten, written as powers."""
    axis.set_ticks([10.0 ** e for e in range(first, last + 1, step)],
                   [tens(e) for e in range(first, last + 1, step)])
    axis.set_minor_locator(ticker.NullLocator())


def plain(axis, values, unit=""):
    """Ticks at these values, written in full."""
    axis.set_ticks(values, [f"{value:g}{unit}" for value in values])
    axis.set_minor_locator(ticker.NullLocator())


TILE = 19  # pixels


class Tiles:
    """Panels of tiles: a row a method, a column a power of ten, in each tile a percentage.

    No tile lies on another. Of fewer than FEW rays there is a dot, of none nothing.
    """

    def __init__(self, names, note):
        self.names, self.note, self.blocks = names, note, []

    def block(self, title, rows, panels, remark=""):
        """A block below the last one. panels: (x label, columns, cells), where cells[row][column]
        is (counted, of all)."""
        self.blocks.append((title, rows, panels, remark))

    def draw(self):
        left, between, above, below = 8 + 6.2 * max(map(len, self.names)), 20, 30, 42
        widths = [sum(TILE * len(panel[1]) + between for panel in block[2])
                  for block in self.blocks]
        heights = [TILE * len(block[1]) + above + below + (14 if block[3] else 0)
                   for block in self.blocks]
        width, height = max(720, left + max(widths)), sum(heights) + 34
        fig = pyplot.figure(figsize=(width / 72, height / 72))
        top = height
        for (title, rows, panels, remark), tall in zip(self.blocks, heights):
            x = left
            low = top - above - TILE * len(rows)
            fig.text(8 / width, (top - 18) / height, title, weight="bold", fontsize=10)
            for i, (label, columns, cells) in enumerate(panels):
                axes = fig.add_axes([x / width, low / height, TILE * len(columns) / width,
                                     TILE * len(rows) / height])
                tiles(axes, rows if i == 0 else [""] * len(rows), columns, cells, label)
                x += TILE * len(columns) + between
            if remark:
                fig.text(left / width, (low - below - 2) / height, remark, color=GRAY)
            top -= tall
        key(fig, 8, 14, width, height, self.note)
        return fig


def key(fig, x, y, width, height, note):
    axes = fig.add_axes([x / width, y / height - 6 / height, 186 / width, 13 / height])
    axes.axis("off")
    axes.set(xlim=(0, 186), ylim=(0, 13))
    for i, (_, color) in enumerate(STEPS):
        axes.add_patch(pyplot.Rectangle((i * 36, 0), 36, 13, facecolor=color))
        axes.text(i * 36 + 18, 6.5, ("<1 %", "1–4", "5–19", "20–49", "50–100")[i], fontsize=7.5,
                  color=ON_DARK if i > 2 else ON_LIGHT, ha="center", va="center")
    fig.text((x + 194) / width, (y - 3) / height, note, color=GRAY)


def tiles(axes, rows, columns, cells, label):
    axes.set(xlim=(0, len(columns)), ylim=(len(rows), 0), xlabel=label)
    axes.grid(False)
    axes.set_xticks([i + 0.5 for i in range(len(columns))][::2],
                    [tens(column) for column in columns][::2])
    axes.set_yticks([i + 0.5 for i in range(len(rows))], rows)
    axes.tick_params(length=0)
    for side in axes.spines.values():
        side.set_visible(False)
    for y, row in enumerate(cells):
        for x, (counted, rays) in enumerate(row):
            share = 100 * counted / rays
            step = next(i for i, (limit, _) in enumerate(STEPS)
                        if share < 1 or round(share) < limit)
            drawn = counted >= FEW
            axes.add_patch(pyplot.Rectangle((x, y), 1, 1, linewidth=0.6, edgecolor=FAINT,
                                            facecolor=STEPS[step][1] if drawn else CARD))
            if drawn:
                axes.text(x + 0.5, y + 0.52, f"{share:.0f}" if share >= 1 else "<1", fontsize=7.5,
                          color=ON_DARK if step > 2 else ON_LIGHT, ha="center", va="center")
            elif counted:
                axes.plot([x + 0.5], [y + 0.5], ".", color=GRAY, markersize=4)


def content(title, figure):
    """What a plot shows, whatever version of matplotlib draws it: its words, and its points."""
    lines = [title]
    for axes in figure.axes:
        lines += [axes.get_title("left"), axes.get_xlabel(), axes.get_ylabel()]
        lines += [f"{text.get_text()} {text.get_position()}" for text in axes.texts]
        for axis in (axes.xaxis, axes.yaxis):
            if isinstance(axis.get_major_formatter(), ticker.FixedFormatter):
                lines += [text.get_text() for text in axis.get_ticklabels()]
        for line in axes.lines:
            x, y = (" ".join(f"{float(v):.6g}" for v in line.get_data()[i]) for i in (0, 1))
            lines += [f"{line.get_label()} {line.get_color()} {line.get_marker()}: {x} | {y}"]
    lines += [text.get_text() for text in figure.texts]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()


def smaller(source):
    """Names for the styles, which many parts have alike, with the colors of a dark card; and
    hundredths of a pixel."""
    names = {}

    def part(tag):
        named = re.sub(r'style="([^"]*)"', lambda style: f'class="{name(style[1])}"', tag[0])
        rounded = re.sub(r"\d+\.\d{3,}", lambda number: f"{float(number[0]):.2f}".rstrip("0").rstrip("."), named)
        return re.sub(r' d="[^"]*"', lambda path: re.sub(r" ?([A-Zz]) ?", r"\1", path[0]), rounded)

    def name(style):
        return names.setdefault(style, f"s{len(names)}")

    def dark(style):
        pens = re.findall(r"(fill|stroke): (#\w+)", style)
        return ";".join(f"{pen}:{DARK[color]}" for pen, color in pens if color in DARK)

    source = re.sub(r"<[a-z][^>]*>", part, source)
    light = "".join(f".{name}{{{style}}}" for style, name in names.items())
    dark_rules = "".join(f".{name}{{{dark(style)}}}" for style, name in names.items() if dark(style))
    return source, f"<style>{light}@media (prefers-color-scheme:dark){{{dark_rules}}}</style>\n"


def svg(title, figure):
    """The file: what it shows, for readers who do not see it and for the test; and both cards."""
    file = io.StringIO()
    figure.savefig(file, format="svg", metadata={"Date": None, "Creator": None})
    pyplot.close(figure)
    source = re.sub(r"<metadata>.*?</metadata>\s*", "", file.getvalue(), flags=re.S)
    source = source[source.index("<svg"):]
    # Enlarged, and without comments and ids.
    source = re.sub(r'(width|height)="([\d.]+)pt"',
                    lambda found: f'{found[1]}="{float(found[2]) * ENLARGED:g}"', source, count=2)
    source = re.sub(r'<!--.*?-->| transform="rotate\(-0[^"]*"', "", source, flags=re.S)
    source = re.sub(r' id="\w+_[\d.]+"(?=/?>)', "", source)
    source = re.sub(r"<g>\s*(<(?:path|text)[^>]*(?:/>|>[^<]*</text>))\s*</g>|<g/>", r"\1", source)
    source = re.sub(r"\s*\n\s*(?=[A-Za-z\"])", " ", source)  # the lines of a path
    source = re.sub(r"\s*\n\s*", "\n", source)
    source, style = smaller(source)
    head = f"<title>{title}</title>\n<!-- content {content(title, figure)} -->\n{style}"
    return source.replace(">", ' role="img">\n' + head, 1).rstrip() + "\n"
