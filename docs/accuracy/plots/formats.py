"""A sphere's textbook formula in other arithmetic: the error of a hit, and its time."""
from data import read, where
from style import SERIES, decades, figure, plain

KINDS = {"sphere": "t of a sphere, 2 to 1,000 radii away", "root": "1 / √x"}


def plots():
    rows = read("formats")
    fig, axes = figure(720, 380)
    for (what, label), look in zip(KINDS.items(), SERIES):
        own = where(rows, what=what)
        xs = [float(row["nanoseconds"]) for row in own]
        ys = [max(float(row["most"]), 1e-17) for row in own]  # none is drawn below all
        axes.plot(xs, ys, label=label, **dict(look, linestyle=""))
        for row, x, y in zip(own, xs, ys):
            side = 1 if "Kahan" in row["form"] or row["form"] + what == "floatroot" else -1
            axes.annotate(row["form"], (x, y), xytext=(7 * side, -3), textcoords="offset points",
                          fontsize=8, ha="left" if side > 0 else "right")
    axes.set(xscale="log", yscale="log", xlim=(0.4, 200), xlabel="nanoseconds a call",
             title="Relative error that one answer in 1,000 exceeds")
    plain(axes.xaxis, [0.5, 1, 2, 5, 10, 20, 50, 100])
    decades(axes.yaxis, -18, 0, 3)
    axes.legend(loc="lower left")
    yield "formats", "Arithmetic below float and above double: error and time", fig
