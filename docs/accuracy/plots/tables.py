"""The tables of accuracy.md, in Markdown."""
import math

from data import CHANGES, STAGES, decade, different, front, middle, nanoseconds, number, read, where
from words import exponent, power, thousands, two_digits


def table(heads, rows):
    lines = ["".join(f"| {head} " if head else "| " for head in heads), "|---" * len(heads)]
    lines += ["".join(f"| {cell} " for cell in row) for row in rows]
    return "".join(line + "|\n" for line in lines)


def shape_tables():
    costs, errors = read("shape_costs"), read("shape_errors")
    for shape in STAGES:
        own_costs, own = where(costs, shape=shape), where(errors, shape=shape)
        forms = different(own, "form")
        unit = nanoseconds(own_costs, forms[1], "double")
        rows = []
        for precision in different(own, "precision"):
            for row in where(own, precision=precision, axis="all"):
                hit, miss = (nanoseconds(own_costs, row["form"], precision, rays) / unit
                             for rays in ("hit", "miss"))
                rows.append([row["form"], precision, two_digits(hit), two_digits(miss),
                             power(float(row["median"])), power(float(row["most"])),
                             thousands(1e6 * float(row["wrong"]) / float(row["rays"]))])
        yield shape, table(["", "precision", "a hit", "a miss", "typical error",
                            "one hit in 1000 exceeds", "wrong of a million"], rows)


def contact():
    rows, lines = read("contact"), []

    def share(rows, column):
        return thousands(1e6 * sum(float(row[column]) for row in rows)
                         / sum(float(row["rays"]) for row in rows))
    for policy in different(rows, "policy"):
        for precision in different(rows, "precision"):
            sizes = [where(rows, policy=policy, precision=precision, size=size)
                     for size in ("1e-06", "1", "1e+06")]
            lines.append([policy, precision] + [f"{share(own, 'self hits')}, {share(own, 'missed')}"
                                                for own in sizes])
    return table(["", "precision", *(f"size {size}: self-hits, missed"
                                     for size in ("10⁻⁶", "1", "10⁶"))], lines)


def slope(rows):
    """Of the line that fits best, in logarithms, the error against the rays."""
    xs = [math.log(float(row["rays"])) for row in rows]
    ys = [math.log(float(row["error"])) for row in rows]
    x, y, n = sum(xs), sum(ys), len(rows)
    value = ((n * sum(a * b for a, b in zip(xs, ys)) - x * y)
             / (n * sum(a * a for a in xs) - x * x))
    return f"{value:.2f}".replace("-", "−")


def penumbra():
    rows, lines = read("penumbra"), []
    for way in different(rows, "way"):
        own = where(rows, way=way)
        for i, asked in enumerate(different(own, "asked")):
            turns = where(own, asked=asked)
            row = turns[0]
            lines.append([way + (f", to 1/{asked}" if way == "adaptive" else ""),
                          two_digits(float(row["rays"])), two_digits(middle(turns, "microseconds")),
                          two_digits(float(row["error"])), two_digits(float(row["most"])),
                          slope(own) if i == 0 else ""])
    return table(["", "rays", "microseconds", "error", "largest error", "slope"], lines)


def mirrors():
    rows, lines = read("mirrors"), []
    depths = different(rows, "depth")
    longest = middle(where(rows, depth=depths[-1]), "seconds")
    for depth in depths:
        turns = where(rows, depth=depth)
        row = turns[0]
        lines.append([depth, two_digits(middle(turns, "seconds") / longest),
                      two_digits(float(row["error"])), row["most"],
                      two_digits(100 * float(row["seen"])) + " %"])
    return table(["depth", "time", "error", "largest error", "pixels off by more than 2 levels"],
                 lines)


def hierarchy():
    rows, lines = read("hierarchy"), []
    for count in different(rows, "spheres"):
        turns = where(rows, spheres=count)
        lines.append([count] + [two_digits(middle(turns, column)) if turns[0][column] else ""
                                for column in ("list", "balls", "hierarchy")])
    return table(["spheres", "list, ns", "in bounding spheres, ns", "in a hierarchy, ns"], lines)


def decimation():
    rows, lines = read("decimation"), []
    counts = different(rows, "triangles")
    whole = middle(where(rows, triangles=counts[0]), "seconds")
    for count in counts:
        turns = where(rows, triangles=count)
        lines.append([thousands(float(count)), two_digits(middle(turns, "seconds") / whole),
                      two_digits(float(turns[0]["error"])),
                      two_digits(100 * float(turns[0]["seen"])) + " %"])
    return table(["triangles", "time", "error", "pixels off by more than 2 levels"], lines)


def pictures():
    rows, lines = read("pictures"), []
    for scene in different(rows, "scene"):
        of = {precision: where(rows, scene=scene, precision=precision)
              for precision in ("float", "double", "exact")}
        unit = middle(of["double"], "seconds")
        shares = [thousands(1e5 * middle(of[precision], column)) for precision, column in
                  (("double", "other"), ("float", "other"), ("float", "seen"), ("float", "edges"))]
        lines.append([f"`{scene}`", two_digits(middle(of["float"], "seconds") / unit),
                      two_digits(middle(of["exact"], "seconds") / unit), *shares])
    return table(["scene", "time: float", "exact", "pixels other than exact's, of 100,000: double",
                  "float", "by more than 2 levels", "on an edge"], lines)


def input_rounding():
    rows, parts = read("input_rounding"), []
    shown = {"moved": (2, 10), "scaled": (-12, 12), "gap": (-9, -1)}  # powers of ten
    for change, label in CHANGES.items():
        own = where(rows, change=change)
        ats = [at for at in different(own, "at")
               if shown[change][0] <= decade(at) <= shown[change][1]]
        parts.append(table(
            [label] + ["10" + exponent(decade(at)) for at in ats],
            [[precision] + [two_digits(100 * middle(where(own, at=at, precision=precision), "seen"))
                            + " %" for at in ats] for precision in ("float", "double")]))
    return "\n".join(parts)


def options_of(row, rows):
    """As a user types them; those of which the scene has no use are left out."""
    words = []
    if row["pixel_error"] != "0":
        words.append(f"--pixel-error {row['pixel_error']}")
    elif row["samples"] != "1":
        words.append(f"--samples {row['samples']}")
    if len(different(rows, "shadow_samples")) > 1:
        if row["shadow_samples"] != "0":
            words.append(f"--shadow-samples {row['shadow_samples']}")
        else:
            words.append(f"--shadow-error {row['shadow_error']}"
                         f" --shadow-agree {row['shadow_agree']}")
    if len(different(rows, "depth")) > 1:
        words.append(f"--depth {row['depth']}")
    if row["hierarchy_from"] != "0":
        words.append(f"--hierarchy-from {row['hierarchy_from']}")
    if row["precision"] == "float":
        words.append("--precision float")
    return f"`{' '.join(words)}`" if words else "one ray"


def front_table():
    rows, lines = read("front"), []
    for scene in different(rows, "scene"):
        own = where(rows, scene=scene)
        cells, line = where(own, what="cell"), [f"`{scene}`"]
        for asked in (8, 4, 2, 1):
            enough = [row for row in front(own) if number(row, "error") <= asked]
            line.append(f"{two_digits(number(enough[0], 'time'))}: {options_of(enough[0], cells)}"
                        if enough else "none found")
        lines.append(line)
    return table(["scene", *(f"error {asked}" for asked in (8, 4, 2, 1))], lines)


KNOBS = {"pixels": ("samples", "pixel_error"),
         "shadows": ("shadow_samples", "shadow_error", "shadow_agree"), "depth": ("depth",)}


def spending():
    """Which settings change along the front, from the cheapest picture on."""
    rows, lines = read("front"), []
    for scene in different(rows, "scene"):
        own = front(where(rows, scene=scene, precision="double", hierarchy_from="0"))
        steps = []
        for before, after in zip(own, own[1:]):
            changed = " and ".join(knob for knob, columns in KNOBS.items()
                                   if any(before[column] != after[column] for column in columns))
            if changed and (not steps or steps[-1][0] != changed):
                steps.append([changed, ""])
            if changed:
                steps[-1][1] = two_digits(number(after, "error"))
        lines.append([f"`{scene}`", two_digits(number(own[0], "error")),
                      ", then ".join(f"{knob} to {error}" for knob, error in steps)])
    return table(["scene", "the cheapest picture's error", "spend on, until the error is"], lines)


def choices():
    rows, lines = read("choices"), []
    for scene in different(rows, "scene"):
        own, line = where(rows, scene=scene), [f"`{scene}`"]
        for asked in ("1", "4"):
            turns = where(own, goal="tolerance", asked=asked)
            line += [f"{100 * middle(turns, 'kept'):.1f} %",
                     two_digits(middle(turns, "seconds") / middle(turns, "best"))]
        for asked in ("1", "3"):
            line.append(two_digits(middle(where(own, goal="time", asked=asked), "seconds")) + " s")
        lines.append(line)
    return table(["scene", "`--tolerance 1`: kept by", "time", "`--tolerance 4`: kept by", "time",
                  "`--time 1`", "`--time 3`"], lines)


def tables():
    """The page's markers, and what belongs between them."""
    return {**dict(shape_tables()), "contact": contact(), "penumbra": penumbra(),
            "mirrors": mirrors(), "hierarchy": hierarchy(), "decimation": decimation(),
            "pictures": pictures(), "input rounding": input_rounding(), "front": front_table(),
            "spending": spending(), "choices": choices()}
