"""Rays through a pixel: the error of six pictures against the time, for four ways to choose points."""
from data import different, read, where
from style import SERIES, figure, plain


def plots():
    rows = read("pixels")
    scenes = different(rows, "scene")
    fig, panels = figure(720, 430, 3, rows=2, sharey=True)
    for scene, axes in zip(scenes, panels.flat):
        own = where(rows, scene=scene)
        for way, look in zip(("regular", "spread", "jittered", "adaptive"), SERIES):
            points = [(float(row["time"]), float(row["error"]))
                      for row in where(own, way=way)]
            axes.plot(*zip(*sorted(points)), label=way, **look)
        axes.set(xscale="log", yscale="log", title=scene)
        plain(axes.xaxis, [1, 4, 16, 64, 256])
        plain(axes.yaxis, [0.2, 0.5, 1, 2, 5, 10])
    for axes in panels[1]:
        axes.set_xlabel("time, one ray = 1")
    for axes in panels[:, 0]:
        axes.set_ylabel("error, of 255")
    panels[1, 1].legend(loc="lower left")
    yield "pixels", "Rays through a pixel: error and time of four ways to choose them", fig
