"""The CSV files that `./course measure` writes."""
import csv
import math
from pathlib import Path
from statistics import median_high, quantiles

FOLDER = Path(__file__).resolve().parent.parent
STAGES = {"sphere": "step03_sphere", "plane": "step04_plane", "triangle": "step05_triangle",
          "square": "step06_square", "cylinder": "step07_cylinder", "cone": "step08_cone"}
CHANGES = {"moved": "moved by", "scaled": "scaled by", "gap": "gap between two squares"}


def read(name):
    with open(FOLDER / f"{name}.csv", encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def where(rows, **words):
    return [row for row in rows if all(row[key] == word for key, word in words.items())]


def different(rows, column):
    """The words of a column, in the order in which they first occur."""
    return list(dict.fromkeys(row[column] for row in rows))


def number(row, column):
    return float(row[column])


def front(rows):
    """The settings that no other beats in time and error, from the cheapest on."""
    best, found = float("inf"), []
    cells = where(rows, what="cell")
    for row in sorted(cells, key=lambda row: (number(row, "time"), number(row, "error"))):
        if number(row, "error") < best:
            best = number(row, "error")
            found.append(row)
    return found


def middle(rows, column):
    """The median over several turns."""
    return median_high(float(row[column]) for row in rows)


def ratios(rows, units, column):
    """Of two times, turn by turn."""
    return [number(row, column) / number(unit, column) for row, unit in zip(rows, units, strict=True)]


def quartiles(values):
    first, _, third = quantiles(values, n=4, method="inclusive")
    return first, third


def decade(word):
    return round(math.log10(float(word)))


def nanoseconds(costs, form, precision, rays="hit"):
    """The quickest turn counts: what others do on a machine makes turns longer."""
    return min(float(row["nanoseconds"])
               for row in where(costs, form=form, precision=precision, rays=rays))
