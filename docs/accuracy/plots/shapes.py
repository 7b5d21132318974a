"""The forms of intersecting each shape: their time, their errors, and their wrong decisions."""
from data import STAGES, decade, different, nanoseconds, read, where
from style import DOUBLE, FEW, FLOAT, INK, Tiles, decades, figure, plain


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


def costs_of_shapes():
    """The forms of intersecting each shape: what they cost, and how far off they are."""
    costs, errors = read("shape_costs"), read("shape_errors")
    for shape, stage in STAGES.items():
        yield (f"{stage}_cost", f"Forms for a {shape}: time and error",
               cost(where(costs, shape=shape), where(errors, shape=shape)))


def wrong(errors, grazing):
    """Tiles for the sweeps on which some form is wrong; the others are named below."""
    axes = {"distance": "from a distance, in sizes of the shape",
            "offset": "moved away from the origin, in sizes",
            "grazing": grazing}
    drawing = Tiles(different(errors, "form"), "percent of about 2,000 rays; "
                    f"a dot: 1 to {FEW - 1} rays, which may be chance; empty: none")
    for precisions in (["float"], ["double", "exact"]):
        forms = [(form, precision) for precision in precisions
                 for form in different(where(errors, precision=precision), "form")]
        panels, remarks = [], []
        for axis, label in axes.items():
            own = [where(errors, form=form, precision=precision, axis=axis)
                   for form, precision in forms]
            cells = [[(int(row["wrong"]), int(row["rays"])) for row in rows] for rows in own]
            most = max(counted for row in cells for counted, _ in row)
            if most >= FEW:
                panels.append((label, [decade(row["at"]) for row in own[0]], cells))
            else:
                remarks.append(f"{label.split(',')[0]}, 1 to 10⁸: " + (
                    f"at most {most} of 2,000 rays wrong" if most else "no ray wrong"))
        drawing.block(f"Wrong decisions, {precisions[0]}", [form for form, _ in forms], panels,
                      "; ".join(remarks))
    return drawing.draw()


def wrong_decisions():
    """The forms of intersecting each shape: how often they decide wrongly, and where."""
    errors = read("shape_errors")
    for shape, stage in STAGES.items():
        flat = shape in ("plane", "triangle", "square")
        yield (f"{stage}_wrong", f"Forms for a {shape}: the share of wrong decisions",
               wrong(where(errors, shape=shape), "leaning on the face, by a slope of at least"
                     if flat else "past the silhouette, by at least so many sizes"))


def plots():
    yield from costs_of_shapes()
    yield from wrong_decisions()
