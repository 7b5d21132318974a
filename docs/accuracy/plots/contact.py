"""Rays that leave a surface: what they hit by mistake and what they miss, at every size of a scene."""
from data import decade, different, read, where
from style import FEW, Tiles


def plots():
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
