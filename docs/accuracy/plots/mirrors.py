"""Mirror upon mirror: the error of the picture and its time, against the depth."""
from data import different, middle, read, where
from style import SERIES, figure


def plots():
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
