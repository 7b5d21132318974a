"""The pixels that float and double lose of a scene that is moved, scaled, or has a small gap."""
from data import CHANGES, decade, different, read, where
from style import FEW, Tiles, tens

PIXELS = 240 * 180


def plots():
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
