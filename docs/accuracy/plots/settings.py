"""All settings together: errors and times of two pictures; and what each is wrong by in eight."""
from data import different, front, number, read, where
from style import BLUE, FAINT, GRAY, GREEN, INK, PURPLE, SERIES, VERMILION, decades, figure, plain
from tables import SHOWN


def points(rows):
    return [(number(row, "time"), number(row, "error")) for row in rows]


def panel(axes, scene, rows):
    axes.plot(*zip(*points(where(rows, what="cell"))), color=FAINT, linestyle="", marker=".", markersize=4,
              label="other settings")
    axes.plot(*zip(*points(front(rows))), label="the front", **dict(SERIES[1], markersize=4))
    chosen = [row for row in rows if row["what"].startswith("tolerance")]
    if chosen:
        axes.plot(*zip(*points(chosen)), label="--tolerance 8, 4, 2, 1",
                  **dict(SERIES[0], linestyle="", markersize=6, markerfacecolor="none"))
    axes.plot([1], [number(where(where(rows, what="cell"), **DEFAULT)[0], "error")], label="the defaults",
              **dict(SERIES[2], linestyle="", markersize=7))
    axes.set(xscale="log", yscale="log", title=scene, ylabel="error, of 255", xlim=(0.2, 100), ylim=(0.3, 30))
    plain(axes.xaxis, [1, 10, 100])
    plain(axes.yaxis, [0.5, 1, 2, 5, 10, 20])


DEFAULT = dict(samples="1", pixel_error="0", shadow_samples="16", shadow_error="0", depth="8",
               precision="double", hierarchy_from="0")
DRAWN = {"cornell_box": "hard shadows: cornell_box", "step11_soft_shadows": "a lamp with a size: step11_soft_shadows"}


def fronts(rows):
    fig, panels = figure(400, 480, rows=2, sharex=True)
    for (scene, title), axes in zip(DRAWN.items(), panels):
        panel(axes, title, where(rows, scene=scene))
    panels[0].legend(loc="lower left")
    panels[1].set_xlabel("time, defaults = 1")
    return fig


def all_settings():
    """All settings together: the error of two pictures against their time."""
    rows = read("front")
    yield "front", "All settings together: the error of two pictures and their time", fronts(rows)


# Each with its default, and how it is drawn.
SOURCES = [("aliasing", "1", VERMILION, "s"), ("shadows", "16", BLUE, "o"),
           ("depth", "8", GREEN, "^"), ("precision", "0", PURPLE, "D"),
           ("input rounding", "0", GRAY, "v")]
LEAST = 0.01  # of 255: less is drawn as nothing


def bars(rows):
    scenes = different(rows, "scene")
    fig, axes = figure(720, 430)
    for place, (source, default, color, _) in enumerate(SOURCES):
        for i, scene in enumerate(scenes):
            own = where(rows, scene=scene, source=source, value=default)
            error = number(own[0], "error")
            y = i + 0.14 * (place - 2)
            axes.plot([LEAST, max(error, LEAST)], [y, y], color=color, linewidth=5,
                      solid_capstyle="butt", label=source if i == 0 else None)
            if error < LEAST:
                axes.plot([LEAST], [y], color=color, marker="|", markersize=6, linestyle="")
    axes.set(xscale="log", xlim=(LEAST * 0.95, 300), xlabel="error, of 255")
    axes.set_ylim(len(scenes) - 0.5, -0.5)
    axes.set_yticks(range(len(scenes)), scenes)
    axes.grid(False, axis="y")
    plain(axes.xaxis, [0.01, 0.1, 1, 10])
    axes.legend(loc="center right")
    return fig


def perceived(rows):
    fig, axes = figure(720, 400)
    for source, _, color, marker in SOURCES:
        # Equal to six digits: not on a scale of powers.
        own = [row for row in where(rows, source=source)
               if number(row, "error") > LEAST and number(row, "similarity") < 1]
        if not own:
            continue
        axes.plot([number(row, "error") for row in own],
                  [1 - number(row, "similarity") for row in own], label=source, color=color,
                  marker=marker, linestyle="")
    for letter, _, words in SHOWN:
        row = where(rows, **words)[0]
        axes.annotate(letter, (number(row, "error"), 1 - number(row, "similarity")), color=INK,
                      xytext=(-4, 8), textcoords="offset points", weight="bold")
    axes.set(xscale="log", yscale="log", xlabel="error, of 255", ylabel="1 − structural similarity")
    plain(axes.xaxis, [0.01, 0.1, 1, 10, 100])
    decades(axes.yaxis, -6, -1, 1)
    axes.legend(loc="upper left")
    return fig


def each_setting():
    """What the settings of eight pictures are wrong by, one at a time, in levels of 255; and that error
beside the structural similarity."""
    rows = read("sources")
    yield "sources", "What the default of each setting is wrong by, in eight pictures", bars(rows)
    yield "perceived", "Errors of eight pictures in levels and in similarity", perceived(rows)


def plots():
    yield from all_settings()
    yield from each_setting()
