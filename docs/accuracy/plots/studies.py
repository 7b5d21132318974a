"""Plots of one study each."""
from data import CHANGES, decade, different, middle, read, where
from style import FEW, SERIES, Tiles, decades, figure, plain, tens


def contact():
    """Rays that leave a surface: what they hit by mistake and what they miss, at every size of a scene."""
    rows = read("contact")
    policies, sizes = different(rows, "policy"), different(rows, "size")
    fewest = 100000
    drawing = Tiles(policies, "")
    for precision in different(rows, "precision"):
        panels = []
        for column, label in (("self hits", "false hits of the ray's own surface, by size of scene"),
                              ("missed", "occluders missed, by size of scene")):
            cells = []
            for policy in policies:
                own = [where(rows, policy=policy, precision=precision, size=size)
                       for size in sizes]
                cells.append([(sum(int(row[column]) for row in shapes),
                               sum(int(row["rays"]) for row in shapes)) for shapes in own])
            fewest = min(fewest, *(rays for row in cells for _, rays in row))
            panels.append((label, [decade(size) for size in sizes], cells))
        drawing.block(f"Rays that leave a surface, {precision}", policies, panels)
    drawing.note = (f"percent of over {fewest // 1000 * 1000:,} rays; a dot: 1 to {FEW - 1} rays, "
                    "which may be chance; empty: none")
    yield "step10_shadows_contact", "Ways off a surface: false self-hits, missed occluders", \
        drawing.draw()


def penumbra():
    """Shadows of a light with a size: the error against the time, for each way of spreading its rays."""
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


def mirrors():
    """Mirror upon mirror: the error of the picture and its time, against the depth."""
    rows = read("mirrors")
    depths = different(rows, "depth")
    turns = [where(rows, depth=depth) for depth in depths]
    fig, (errors, times) = figure(720, 230, 2)
    errors.plot([int(d) for d in depths], [float(t[0]["error"]) for t in turns], **SERIES[0])
    errors.set(title="Error in levels of 255, root mean square", xlabel="depth", ylim=(-2, 48))
    all_of_it = middle(turns[-1], "seconds")
    times.plot([int(d) for d in depths], [middle(t, "seconds") / all_of_it for t in turns],
               **SERIES[1])
    times.set(title=f"Time, depth {depths[-1]} = 1", xlabel="depth", ylim=(0, 1.1))
    yield "step12_mirror_depth", "Mirrors: error and time of a picture, by depth", fig


def hierarchy():
    """The nearest of many spheres: in a list, in bounding spheres, and in a hierarchy."""
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


def decimation():
    """A mesh with fewer triangles: the pixels that differ, and the time."""
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


def pixels():
    """Rays through a pixel: the error of six pictures against the time, for four ways to choose points."""
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


PIXELS = 240 * 180


def input_rounding():
    """The pixels that float and double lose of a scene that is moved, scaled, or has a small gap."""
    rows = read("input_rounding")
    precisions = different(rows, "precision")
    drawing = Tiles(precisions, f"percent of {PIXELS:,} pixels; a dot: 1 to {FEW - 1} pixels; "
                    "empty: none")
    panels, remarks = [], []
    for change, label in CHANGES.items():
        own = where(rows, change=change)
        cells = [[(round(float(row["seen"]) * PIXELS), PIXELS)
                  for row in where(own, precision=precision)] for precision in precisions]
        ats = [decade(at) for at in different(own, "at")]
        if any(counted for row in cells for counted, _ in row):
            panels.append((label, ats, cells))
        else:
            remarks.append(f"{label} {tens(min(ats))} to {tens(max(ats))}: no pixel")
    drawing.block("Pixels off by more than 2 levels of 255", precisions, panels, "; ".join(remarks))
    yield "input_rounding", "Pixels that a scene loses when moved, scaled, or with a small gap", \
        drawing.draw()


KINDS = {"sphere": "t of a sphere, 2 to 1,000 radii away", "root": "1 / √x"}


def formats():
    """A sphere's textbook formula in other arithmetic: the error of a hit, and its time."""
    rows = read("formats")
    fig, axes = figure(720, 380)
    for (what, label), look in zip(KINDS.items(), SERIES):
        own = where(rows, what=what)
        xs = [float(row["nanoseconds"]) for row in own]
        ys = [max(float(row["most"]), 1e-17) for row in own]  # none is drawn below all
        axes.plot(xs, ys, label=label, **dict(look, linestyle=""))
        for row, x, y in zip(own, xs, ys):
            side = 1 if "Kahan" in row["form"] or row["form"] + what == "floatroot" else -1
            axes.annotate(row["form"], (x, y), xytext=(7 * side, -3), textcoords="offset points",
                          fontsize=8, ha="left" if side > 0 else "right")
    axes.set(xscale="log", yscale="log", xlim=(0.4, 200), xlabel="nanoseconds a call",
             title="Relative error that one answer in 1,000 exceeds")
    plain(axes.xaxis, [0.5, 1, 2, 5, 10, 20, 50, 100])
    decades(axes.yaxis, -18, 0, 3)
    axes.legend(loc="lower left")
    yield "formats", "Arithmetic below float and above double: error and time", fig


def plots():
    yield from contact()
    yield from penumbra()
    yield from mirrors()
    yield from hierarchy()
    yield from decimation()
    yield from pixels()
    yield from input_rounding()
    yield from formats()
