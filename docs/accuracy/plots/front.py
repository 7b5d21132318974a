"""All settings together: the error of eight pictures against their time."""
from data import different, front, number, read, where
from style import FAINT, SERIES, figure, plain


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
    axes.set(xscale="log", yscale="log", title=scene, xlim=(0.2, 3000), ylim=(0.06, 60))
    plain(axes.xaxis, [1, 10, 100, 1000])
    plain(axes.yaxis, [0.1, 0.5, 1, 2, 5, 10, 20, 50])


DEFAULT = dict(samples="1", pixel_error="0", shadow_samples="16", shadow_error="0", depth="8",
               precision="double", hierarchy_from="0")


def fronts(rows):
    scenes = different(rows, "scene")
    fig, panels = figure(720, 630, 3, rows=3, sharey=True)
    for scene, axes in zip(scenes, panels.flat):
        panel(axes, scene, where(rows, scene=scene))
    for axes in (*panels[2, :2], panels[1, 2]):
        axes.set_xlabel("time, defaults = 1")
    for axes in panels[:, 0]:
        axes.set_ylabel("error, of 255")
    key = panels.flat[8]  # the scenes leave one panel
    key.axis("off")
    key.legend(*panels[0, 0].get_legend_handles_labels(), loc="center")
    return fig


def plots():
    rows = read("front")
    yield "front", "All settings together: the error of eight pictures and their time", fronts(rows)
