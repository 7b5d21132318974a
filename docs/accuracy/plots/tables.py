"""The tables of accuracy*.md, in Markdown."""
import math

from data import (CHANGES, STAGES, decade, different, front, middle, nanoseconds, number, quartiles,
                  ratios, read, where)
from statistics import median_high

from words import exponent, power, thousands, two_digits


def table(heads, rows):
    lines = ["".join(f"| {head} " if head else "| " for head in heads), "|---" * len(heads)]
    lines += ["".join(f"| {cell} " for cell in row) for row in rows]
    return "".join(line + "|\n" for line in lines)


def with_spread(value, least, greatest):
    """1.5 (1.4–1.6)."""
    return f"{two_digits(value)} ({two_digits(least)}–{two_digits(greatest)})"


def in_turns(rows, units, column="seconds"):
    """The median of the turns' ratios, and if there are several, the least and the greatest."""
    of_turns = ratios(rows, units, column)
    if len(of_turns) == 1:
        return two_digits(of_turns[0])
    return with_spread(median_high(of_turns), min(of_turns), max(of_turns))


def cost(costs, form, precision, rays, unit):
    """The shortest times in units of the shortest unit, and the quartiles of the turns' ratios."""
    own, units = (where(costs, form=name, precision=width, rays=kind)
                  for name, width, kind in ((form, precision, rays), (*unit, "hit")))
    return with_spread(nanoseconds(costs, form, precision, rays) / nanoseconds(costs, *unit),
                       *quartiles(ratios(own, units, "nanoseconds")))


def shape_tables():
    costs, errors = read("shape_costs"), read("shape_errors")
    for shape in STAGES:
        own_costs, own = where(costs, shape=shape), where(errors, shape=shape)
        forms = different(own, "form")
        unit = forms[1], "double"
        rows = []
        for precision in different(own, "precision"):
            for row in where(own, precision=precision, axis="all"):
                hit, miss = (cost(own_costs, row["form"], precision, rays, unit)
                             for rays in ("hit", "miss"))
                rows.append([row["form"], precision, hit, miss,
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
    deepest = where(rows, depth=depths[-1])
    for depth in depths:
        turns = where(rows, depth=depth)
        row = turns[0]
        lines.append([depth, in_turns(turns, deepest),
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
    whole = where(rows, triangles=counts[0])
    for count in counts:
        turns = where(rows, triangles=count)
        lines.append([thousands(float(count)), in_turns(turns, whole),
                      two_digits(float(turns[0]["error"])),
                      two_digits(100 * float(turns[0]["seen"])) + " %"])
    return table(["triangles", "time", "error", "pixels off by more than 2 levels"], lines)


def pictures():
    rows, lines = read("pictures"), []
    for scene in different(rows, "scene"):
        of = {precision: where(rows, scene=scene, precision=precision)
              for precision in ("float", "double", "exact")}
        shares = [thousands(1e5 * middle(of[precision], column)) for precision, column in
                  (("double", "other"), ("float", "other"), ("float", "seen"), ("float", "edges"))]
        lines.append([f"`{scene}`", *(in_turns(of[precision], of["double"])
                                      for precision in ("float", "exact")), *shares])
    return table(["scene", "time: float", "exact", "pixels other than exact's, of 100,000: double",
                  "float", "by more than 2 levels", "on an edge"], lines)


def memory():
    rows, lines = read("memory"), []
    for what in different(rows, "what"):
        of = {row["precision"]: row["bytes"] for row in where(rows, what=what)}
        lines.append([f"`{what}`" if "_" in what else what,
                      *(thousands(float(of[precision])) for precision in ("float", "double")),
                      two_digits(float(of["float"]) / float(of["double"]))])
    return table(["bytes of", "float", "double", "ratio"], lines)


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
    to_error = row["pixel_error"] != "0"
    if row["samples"] != ("1024" if to_error else "1"):  # the defaults
        words.append(f"--samples {row['samples']}")
    if to_error:
        words.append(f"--pixel-error {row['pixel_error']}")
    if len(different(rows, "shadow_samples")) > 1:
        if row["shadow_samples"] != ("1048576" if row["shadow_error"] != "0" else "16"):  # the defaults
            words.append(f"--shadow-samples {row['shadow_samples']}")
        if row["shadow_error"] != "0":
            words.append(f"--shadow-error {row['shadow_error']}"
                         f" --shadow-agree {row['shadow_agree']}")
    if len(different(rows, "depth")) > 1:
        words.append(f"--depth {row['depth']}")
    if row["hierarchy_from"] != "0":
        words.append(f"--hierarchy-from {row['hierarchy_from']}")
    if row["precision"] == "float":
        words.append("--precision float")
    return f"`{' '.join(words)}`" if words else "one ray"


def time_of(row):
    return with_spread(*(number(row, column) for column in ("time", "least", "greatest")))


def fastest(cells, asked):
    """Of the times that differ by less than they are known, the one with fewest options."""
    enough = [row for row in cells if number(row, "error") <= asked]
    if not enough:
        return "none found"
    least = min(number(row, "time") for row in enough)
    close = [row for row in enough if number(row, "time") <= 1.03 * least]
    row = min(close, key=lambda row: (len(options_of(row, cells).split()), number(row, "time")))
    return f"{time_of(row)}: {options_of(row, cells)}"


def front_table():
    rows, lines = read("front"), []
    for scene in different(rows, "scene"):
        own = where(rows, scene=scene)
        cells, line = where(own, what="cell"), [f"`{scene}`"]
        for asked in (8, 4, 2, 1):
            line.append(fastest(cells, asked))
        lines.append(line)
    return table(["scene", *(f"error {asked}" for asked in (8, 4, 2, 1))], lines)


# Pictures of which the error and the similarity disagree, and the letters of the plot.
SHOWN = [("A", "no reflection", dict(scene="cornell_mirror", source="depth", value="0")),
         ("B", "one ray for a pixel", dict(scene="step10_shadows", source="aliasing", value="1")),
         ("C", "four rays to each light",
          dict(scene="step11_soft_shadows", source="shadows", value="4"))]
KNOBS = {"pixels": ("samples", "pixel_error"),
         "shadows": ("shadow_samples", "shadow_error", "shadow_agree"), "depth": ("depth",)}


def spending():
    """Which settings differ along the front, from the cheapest picture on."""
    rows, lines = read("front"), []
    errors = (16, 8, 4, 2, 1)
    for scene in different(rows, "scene"):
        own = front(where(rows, scene=scene, precision="double", hierarchy_from="0"))
        before, line = own[0], [f"`{scene}`", two_digits(number(own[0], "error"))]
        for error in errors:
            after = next((row for row in own if number(row, "error") <= error), before)
            line.append(", ".join(knob for knob, columns in KNOBS.items()
                                  if any(before[column] != after[column] for column in columns)))
            before = after
        lines.append(line)
    return table(["scene", "the cheapest picture's error",
                  *(f"from there to {error}" if error == errors[0] else f"to {error}"
                    for error in errors)], lines)


def sources():
    """The pictures that the page shows, and how wrong they are."""
    rows, lines = read("sources"), []
    for letter, what, words in SHOWN:
        row = where(rows, **words)[0]
        lines.append([letter, f"`{words['scene']}`, {what}", two_digits(number(row, "error")),
                      f"{number(row, 'similarity'):.3f}"])
    return table(["", "picture", "error, of 255", "structural similarity"], lines)


def analytic():
    """The error against the number of rays, of pixels that are known."""
    rows, lines = read("analytic"), []
    sampled = [row for row in rows if row["rays are"]]
    counts = different(sampled, "rays")
    for picture in different(sampled, "picture"):
        for kind, theory in (("independent", "−0.50"), ("well spread", "−0.75")):
            own = where(sampled, picture=picture, **{"rays are": kind})
            lines.append([picture, kind, *(two_digits(float(row["error"])) for row in own),
                          slope(own), theory])
    return table(["picture", "rays are", *(thousands(float(count)) for count in counts),
                  "slope", "in theory"], lines)


def pipeline():
    """What the steps from rays to levels are worth."""
    rows = read("analytic")

    def level(picture, at="1"):
        value = float(where(rows, picture=picture, rays=at)[0]["error"])
        return two_digits(value) if value >= 1e-4 else power(value)
    lines = [["the edge's levels, rounded to 8 bits", level("8 bits"), "16 bits: twice the bytes"],
             ["its rays encoded for a screen before their mean, not after it",
              level("mean of encoded"), "none: fewer numbers are encoded"],
             ["four times as bright: clamped after the mean of the rays, not before it",
              level("clamped after"), "none"]]
    for name in ("box", "tent", "Gauss"):
        lines.append([f"pixel filter {name}: black and white stripes of 4 pixels, which should keep"
                      " 255, keep", level(f"filter {name}", "4"), ""])
        lines.append([f"pixel filter {name}: stripes of 1.25 pixels, which should vanish, keep",
                      level(f"filter {name}", "1.25"),
                      "none" if name == "box" else "a ray counts for several pixels"])
    for precision, cost in (("float", "`double`: up to 1.1 times the time"), ("double", "")):
        for place in ("inside", "silhouette"):
            lines.append([f"Phong's terms of a sphere in `{precision}`, {place}",
                          level(f"sphere's {place} in {precision}"), cost])
    lines.append(["two facing mirrors of 0.8: depth 8 instead of endless",
                  level("chain of mirrors", "8"), "`--depth 24`: hardly any"])
    return table(["step", "levels", "what it costs"], lines)


def formats():
    """Other arithmetic than float and double."""
    names = {"sphere": "t of a sphere", "root": "1 / √x"}
    return table(["", "arithmetic", "nanoseconds", "typical error", "one in 1000 exceeds"],
                 [[names[row["what"]], row["form"], two_digits(float(row["nanoseconds"])),
                   power(float(row["median"])), power(float(row["most"]))]
                  for row in read("formats") if row["what"] in names])


def boxes():
    """A hierarchy whose boxes have few bits: boxes tested, and leaves reached, of each ray."""
    rows = [row for row in read("formats") if row["boxes"]]
    bits = {"double": "48", "float": "24", "half": "12", "bfloat16": "12"}
    places = different(rows, "what")
    return table(["boxes in", "bytes of one", *(place.replace("boxes at 0", "at the origin")
                                                .replace("boxes at", "moved by") for place in places)],
                 [[form, bits[form], *(f"{float(row['boxes']):.0f}, {float(row['leaves']):.1f}"
                                       for row in where(rows, form=form))]
                  for form in different(rows, "form")])


def flags():
    """Compiler flags: time, bits and wrong decisions of three references."""
    rows, lines = read("flags"), []
    shapes, names = different(rows, "shape"), different(rows, "flags")
    for name in names:
        turns = [where(rows, flags=name, shape=shape) for shape in shapes]
        other = [shape for shape, own in zip(shapes, turns)
                 if own[0]["bits"] != where(rows, flags=names[0], shape=shape)[0]["bits"]]
        lines.append([f"`{name.replace(' -DRT_FLUSH_TO_ZERO', '')}`"
                      + (", flush to zero" if "FLUSH" in name else ""),
                      *(f"{two_digits(min(number(row, 'nanoseconds') for row in own))}, "
                        f"{thousands(1e6 * number(own[0], 'wrong') / number(own[0], 'rays'))}"
                        for own in turns),
                      turns[-1][0]["leaks"], ", ".join(other) or "none"])
    return table(["flags", *(f"{shape}: ns, wrong of a million" for shape in shapes),
                  "leaks of a million", "other bits"], lines)


def tables():
    """The page's markers, and what belongs between them."""
    return {**dict(shape_tables()), "contact": contact(), "penumbra": penumbra(),
            "mirrors": mirrors(), "hierarchy": hierarchy(), "decimation": decimation(),
            "pictures": pictures(), "memory": memory(), "input rounding": input_rounding(),
            "front": front_table(), "sources": sources(), "spending": spending(),
            "analytic": analytic(), "pipeline": pipeline(), "formats": formats(),
            "boxes": boxes(), "flags": flags()}
