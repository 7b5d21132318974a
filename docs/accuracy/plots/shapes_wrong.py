"""The forms of intersecting each shape: how often they decide wrongly, and where."""
from data import STAGES, decade, different, read, where
from style import FEW, Tiles


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


def plots():
    errors = read("shape_errors")
    for shape, stage in STAGES.items():
        flat = shape in ("plane", "triangle", "square")
        yield (f"{stage}_wrong", f"Forms for a {shape}: the share of wrong decisions",
               wrong(where(errors, shape=shape), "leaning on the face, by a slope of at least"
                     if flat else "past the silhouette, by at least so many sizes"))
