"""The forms of intersecting each shape: what they cost, and how far off they are."""
from data import STAGES, different, nanoseconds, read, where
from style import DOUBLE, FLOAT, INK, decades, figure, plain

CERTIFIED = dict(color=INK, marker="D")


def cost(costs, errors):
    """A row a form: its time, and its errors from the typical one to one hit in a thousand."""
    forms = different(errors, "form")
    fig, (times, exact) = figure(720, 92 + 26 * len(forms), 2, sharey=True,
                                 width_ratios=(2, 3))
    unit = nanoseconds(costs, forms[1], "double")
    for precision, look, shift in (("float", FLOAT, -0.16), ("double", DOUBLE, 0.16),
                                   ("exact", CERTIFIED, 0)):
        look = dict(look, linestyle="")
        label = {"exact": "certified"}.get(precision, precision)
        own = where(errors, precision=precision, axis="all")
        ys = [forms.index(row["form"]) + shift for row in own]
        times.plot([nanoseconds(costs, row["form"], precision) / unit for row in own], ys, **look)
        exact.hlines(ys, [max(float(row["median"]), 1e-30) for row in own],
                     [float(row["most"]) for row in own], color=look["color"], linewidth=1.2)
        exact.plot([float(row["most"]) for row in own], ys, label=label, **look)
    times.set(xscale="log", xlim=(0.5, 8), ylim=(len(forms) - 0.5, -0.5),
              title="Time of a hit", xlabel=f"{forms[1]}, double = 1")
    times.set_yticks(range(len(forms)), forms)
    times.tick_params(axis="y", length=0)
    plain(times.xaxis, [0.5, 1, 2, 4, 8])
    exact.set(xscale="log", xlim=(1e-23, 3), title="Error of a hit",
              xlabel="as a part of the largest coordinate;\n"
                     "line: from the typical error; marker: one hit in 1,000 exceeds it")
    decades(exact.xaxis, -20, 0, 4)
    exact.tick_params(axis="y", length=0)
    exact.legend(loc="lower right", bbox_to_anchor=(1, 0.995), ncols=3, frameon=False,
                 borderaxespad=0)
    return fig


def plots():
    costs, errors = read("shape_costs"), read("shape_errors")
    for shape, stage in STAGES.items():
        yield (f"{stage}_cost", f"Forms for a {shape}: time and error",
               cost(where(costs, shape=shape), where(errors, shape=shape)))
