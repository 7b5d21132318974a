"""The nearest of many spheres: in a list, in bounding spheres, and in a hierarchy."""
from data import different, middle, read, where
from style import SERIES, figure, plain


def plots():
    rows = read("hierarchy")
    fig, axes = figure(720, 320)
    for column, look in zip(("list", "balls", "hierarchy"), SERIES):
        own = [row for row in rows if row[column]]  # no balls around many
        counts = different(own, "spheres")
        axes.plot([int(count) for count in counts],
                  [middle(where(own, spheres=count), column) for count in counts],
                  label={"list": "list", "balls": "in bounding spheres"}.get(column, "in a hierarchy"), **look)
    axes.set(xscale="log", yscale="log", title="Nanoseconds a ray", xlabel="spheres")
    plain(axes.xaxis, [1, 2, 4, 8, 16, 32, 64, 128, 256, 512])
    plain(axes.yaxis, [10, 100, 1000])
    axes.legend(loc="upper left")
    yield "step13_meshes_hierarchy", "Time to the nearest of many spheres, in three ways", fig
