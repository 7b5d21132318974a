"""A mesh with fewer triangles: the pixels that differ, and the time."""
from data import different, middle, read, where
from style import SERIES, figure, plain


def plots():
    rows = read("decimation")
    counts = different(rows, "triangles")
    turns = [where(rows, triangles=count) for count in counts]
    fig, (pixels, times) = figure(720, 230, 2)
    pixels.plot([int(count) for count in counts], [100 * float(t[0]["seen"]) for t in turns],
                **SERIES[0])
    pixels.set(title="Pixels off by more than 2 levels of 255, %", ylim=(-1.5, 30))
    whole = middle(turns[0], "seconds")
    times.plot([int(count) for count in counts], [middle(t, "seconds") / whole for t in turns],
               **SERIES[1])
    times.set(title="Time, whole mesh = 1", ylim=(0, 1.1))
    for axes in (pixels, times):
        axes.set(xscale="log", xlabel="triangles")
        plain(axes.xaxis, [100, 300, 1000, 3000, 10000])
    yield "step13_meshes_decimation", "A mesh with fewer triangles: other pixels, and time", fig
