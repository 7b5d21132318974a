"""All settings together: the error of five pictures against their time; and what the defaults of
each setting are wrong by."""
from data import different, front, number, read, where
from style import BLUE, FAINT, GRAY, GREEN, PURPLE, SERIES, VERMILION, figure, plain

SOURCES = [("aliasing", VERMILION), ("shadows", BLUE), ("depth", GREEN), ("precision", PURPLE),
           ("input rounding", GRAY)]
LEAST = 0.01  # of 255: less is drawn as nothing


def points(rows):
    return [(number(row, "time"), number(row, "error")) for row in rows]


def panel(axes, scene, rows):
    axes.plot(*zip(*points(where(rows, what="cell"))), color=FAINT, linestyle="", marker=".", markersize=4,
              label="other settings")
    axes.plot(*zip(*points(front(rows))), label="the front", **dict(SERIES[1], markersize=4))
    chosen = [row for row in rows if row["what"].startswith("tolerance")]
    axes.plot(*zip(*points(chosen)), label="--tolerance 8, 4, 2, 1",
              **dict(SERIES[0], linestyle="", markersize=6, markerfacecolor="none"))
    axes.plot([1], [number(where(where(rows, what="cell"), **DEFAULT)[0], "error")], label="the defaults",
              **dict(SERIES[2], linestyle="", markersize=7))
    axes.set(xscale="log", yscale="log", title=scene, xlim=(0.4, 1000), ylim=(0.08, 30))
    plain(axes.xaxis, [1, 10, 100, 1000])
    plain(axes.yaxis, [0.1, 0.5, 1, 2, 5, 10, 20])


DEFAULT = dict(samples="1", pixel_error="0", shadow_samples="16", shadow_error="0", depth="8",
               precision="double", hierarchy_from="0")


def fronts(rows):
    scenes = different(rows, "scene")
    fig, panels = figure(720, 430, 3, rows=2, sharey=True)
    for scene, axes in zip(scenes, panels.flat):
        panel(axes, scene, where(rows, scene=scene))
    for axes in (*panels[1, :2], panels[0, 2]):
        axes.set_xlabel("time, defaults = 1")
    for axes in panels[:, 0]:
        axes.set_ylabel("error, of 255")
    key = panels.flat[len(scenes)]  # the scenes leave one panel
    key.axis("off")
    key.legend(*panels[0, 0].get_legend_handles_labels(), loc="center")
    return fig


def sources(rows):
    scenes = different(rows, "scene")
    fig, axes = figure(720, 300)
    for place, (source, color) in enumerate(SOURCES):
        for i, scene in enumerate(scenes):
            error = number(where(rows, scene=scene, what=source)[0], "error")
            y = i + 0.13 * (place - 2)
            axes.plot([LEAST, max(error, LEAST)], [y, y], color=color, linewidth=5,
                      solid_capstyle="butt", label=source if i == 0 else None)
            if error < LEAST:
                axes.plot([LEAST], [y], color=color, marker="|", markersize=6, linestyle="")
    axes.set(xscale="log", xlim=(LEAST * 0.95, 250), xlabel="error, of 255")
    axes.set_ylim(len(scenes) - 0.5, -0.5)
    axes.set_yticks(range(len(scenes)), scenes)
    axes.grid(False, axis="y")
    plain(axes.xaxis, [0.01, 0.1, 1, 10])
    axes.legend(loc="center right")
    return fig


def plots():
    rows = read("front")
    yield "front", "All settings together: the error of five pictures and their time", fronts(rows)
    yield "front_sources", "What the default of each setting is wrong by, in five pictures", \
        sources(rows)
