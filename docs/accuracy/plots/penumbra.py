"""Shadows of a light with a size: the error against the time, for each way of spreading its rays."""
from data import different, middle, read, where
from style import SERIES, figure, plain


def plots():
    rows = read("penumbra")
    fig, axes = figure(720, 340)
    for way, look in zip(different(rows, "way"), SERIES):
        own = where(rows, way=way)
        asked = [where(own, asked=asked) for asked in different(own, "asked")]
        axes.plot([middle(turns, "microseconds") for turns in asked],
                  [float(turns[0]["error"]) for turns in asked], label=way, **look)
    axes.set(xscale="log", yscale="log", xlabel="microseconds a surface",
             title="Error of a color in levels of 255, root mean square")
    plain(axes.xaxis, [0.1, 1, 10, 100])
    plain(axes.yaxis, [0.1, 1, 10])
    axes.legend(loc="lower left")
    yield "step11_soft_shadows_error", "Soft shadows: error and time of four ways to sample", fig
