#!/usr/bin/python3
"""Whole pictures in a page, in Chromium: picture_test.py BUILD PROJECT [STAGE...]

Each stage's scene is drawn as its page draws it, with the camera turned by the mouse, the keyboard
and a slider: each pixel must equal that of the stage's own program for the scene in the editor.
A wrong scene gets the program's error, with line and column, and a scene that needs too much memory or
time an error; the next scene is drawn. Status 77 where Chromium or the engine is missing.
"""
import base64
import contextlib
import http.server
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from chromium import Chromium, program, serve

build, project = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
live = project / "docs/figures/live"
for needed in [program, build / "engine/picture_double.wasm"]:
    if needed is None or not pathlib.Path(needed).exists():
        print(f"skipped: {needed or 'chromium'} is missing")
        sys.exit(77)
programs = {int(path.name[4:6]): path.name for path in project.glob("steps/step*")}
stages = [int(stage) for stage in sys.argv[3:]] or sorted(programs)
width = 160
scenes = {stage: f"{name}.rt" for stage, name in programs.items()}
scenes[13] = "gallery/cornell_mesh.rt"

page = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{0}</title><link rel="icon" href="data:,">
<style>:root {{ color-scheme: light dark }} body {{ width: 660px; margin: 8px }}</style>
<rt-picture stage="{0}" scene="{1}"><p><img src="data:," alt="the picture"></p></rt-picture>
<script type="module" src="/figures/picture.js"></script>"""


class Site(http.server.BaseHTTPRequestHandler):
    """A page for each stage, the script, the engine, and the scenes, as in the book."""
    protocol_version = "HTTP/1.1"

    def log_message(self, *_):
        pass

    def do_GET(self):
        path = pathlib.PurePosixPath(self.path)
        types = {".js": "text/javascript", ".wasm": "application/wasm"}
        status, kind, body = 404, "text/plain", b"not found"
        if path.parent.name == "page":
            status, kind, body = 200, "text/html", page.format(path.name, scenes[int(path.name)]).encode()
        elif self.path.startswith("/figures/"):
            name = path.relative_to("/figures")
            folder = build / "engine" if path.suffix == ".wasm" else live if path.suffix == ".js" else project
            status, kind, body = 200, types.get(path.suffix, kind), (folder / name).read_bytes()
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        with contextlib.suppress(ConnectionError):  # the page is left
            self.wfile.write(body)


finished = """(async () => {
  const figure = document.querySelector("rt-picture");
  for (let i = 0; !figure.finished; ++i) {
    if (i === 6000) throw Error("the picture is not finished");
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  return { status: figure.status.innerText, scene: figure.editor.value, wrong: figure.status.className };
})()"""

# The number of colors of the canvas that differ from a picture file's, and the largest difference.
differences = """(async () => {
  const { canvas } = document.querySelector("rt-picture");
  const picture = await createImageBitmap(await (await fetch("data:image/png;base64,%s")).blob(), { colorSpaceConversion: "none" });
  if (picture.width !== canvas.width || picture.height !== canvas.height) return [-1, `${canvas.width} × ${canvas.height}`];
  const other = Object.assign(document.createElement("canvas"), { width: picture.width, height: picture.height }).getContext("2d");
  other.drawImage(picture, 0, 0);
  const colors = (context) => context.getImageData(0, 0, picture.width, picture.height).data;
  const [shown, right] = [colors(canvas.getContext("2d")), colors(other)];
  const gaps = right.map((color, i) => Math.abs(color - shown[i]));
  return [gaps.filter((gap) => gap > 0).length, Math.max(...gaps)];
})()"""


def run_program(folder, stage, scene):
    """The stage's own picture of a scene, or its error."""
    file, picture = folder / "scene.rt", folder / "picture.png"
    file.write_text(scene)
    picture.unlink(missing_ok=True)
    (folder / "meshes").exists() or (folder / "meshes").symlink_to(project / "scenes/meshes")
    file.write_text(scene.replace("../meshes/", "meshes/"))
    across, down = next(map(int, line.split()[1:3]) for line in [*scene.splitlines(), "R 640 480"] if line.startswith("R "))
    ran = subprocess.run([build / programs[stage], file, "-o", picture, "--size", f"{width}x{round(width * down / across)}",
                          "--quiet"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return picture.read_bytes() if picture.exists() else None, ran.stdout.replace(f"{file}:", "scene.rt:").strip()


def show(chromium, change):
    """Changes the figure, and waits for its picture."""
    chromium.run(f"""(() => {{ const figure = document.querySelector("rt-picture"); figure.finished = false; {change} }})()""")
    return chromium.run(finished)


def edit(chromium, scene):
    return show(chromium, f"figure.editor.value = {json.dumps(scene)}; figure.editor.dispatchEvent(new Event('input'));")


def open_page(chromium, origin, stage):
    chromium.open(f"{origin}/page/{stage}")
    chromium.run("customElements.whenDefined('rt-picture').then((picture) => { picture.widths = [%d]; })" % width)
    return show(chromium, "figure.shadowRoot.querySelector('button').click();")


def turn_by_mouse(chromium):
    x, y = chromium.run("""(({ x, y, width, height }) => [x + width / 2, y + height / 2])
        (document.querySelector("rt-picture").canvas.getBoundingClientRect())""")
    chromium.run("document.querySelector('rt-picture').finished = false")
    chromium.mouse("mousePressed", x, y)
    for share in (0.5, 1):
        chromium.mouse("mouseMoved", x + 40 * share, y + 30 * share)
    chromium.mouse("mouseReleased", x + 40, y + 30)
    return chromium.run(finished)


def turn_by_key(chromium):
    chromium.run("document.querySelector('rt-picture').canvas.focus()")
    for key in ["ArrowLeft", "ArrowUp"]:
        chromium.run("document.querySelector('rt-picture').finished = false")
        chromium.key(key)
        shown = chromium.run(finished)
    return shown


def check(chromium, origin, folder, stage):
    """Errors of the pictures of one stage."""
    errors, seen = [], set()
    chromium.events.clear()
    states = [lambda: open_page(chromium, origin, stage)]
    if stage > 1:  # whose camera does not turn
        around = "const slider = figure.turns[2]; slider.value = 20; slider.dispatchEvent(new Event('input', { bubbles: true }));"
        states += [lambda: turn_by_mouse(chromium), lambda: turn_by_key(chromium), lambda: show(chromium, around)]
    for number, change in enumerate(states):
        shown = change()
        picture, error = run_program(folder, stage, shown["scene"])
        if picture is None or shown["wrong"]:
            errors.append(f"state {number}: {shown['status']}, program: {error}")
            continue
        count, gap = chromium.run(differences % base64.b64encode(picture).decode())
        if count != 0:
            errors.append(f"state {number}: {count} colors differ, by {gap}")
        seen.add(shown["scene"])
    if not errors and len(seen) < len(states) - (stage == 2):  # the sky has no middle to go around
        errors.append("a turn changes nothing")
    return errors + chromium.complaints(origin)


good = "C 0,0,3 0,0,-1 60\nsp 0,0,0 1 200,80,60\n"
wrong = [good + "sp 0,0 1 200,80,60", "C 0,0,3 0,0,-1 60\nsp 0,0,0 one 1,1,1", good + "sp 0,0,0 2,2 1,1,1", "sp 0,0,0 1 1,1,1", "",
         good + "pl 0,0,0 0,1,0 1,1,1", good + "sp 0,0,0 1 200,80,60 mirror:0.5", good + "\0", "C 0,0,3 0,0,-1 wide", good + "L 1,1"]


def check_wrong_scenes(chromium, origin, folder):
    errors = []
    open_page(chromium, origin, 3)
    undefined = chromium.run("""fetch("/figures/picture_double.wasm").then((file) => file.arrayBuffer()).then(WebAssembly.compile)
        .then((engine) => WebAssembly.Module.imports(engine).filter(({ module }) => module === "env").map(({ name }) => name))""")
    errors += [f"{name} is undefined" for name in undefined if not re.search("PixelLog|2rt4(text|code)E", name)]

    def goes_on(after):
        shown = edit(chromium, good)
        picture, _ = run_program(folder, 3, good)
        if shown["wrong"] or chromium.run(differences % base64.b64encode(picture).decode()) != [0, 0]:
            errors.append(f"after {after}: {shown['status']}")

    for scene in wrong:
        shown = edit(chromium, scene)
        _, error = run_program(folder, 3, scene)
        if not shown["wrong"] or not error.startswith(shown["status"].strip()):
            errors.append(f"{scene!r}: {shown['status']}, program: {error}")
        goes_on(repr(scene))
    # A line can be shown, and is selected.
    edit(chromium, wrong[0])
    chromium.run("document.querySelector('rt-picture').line.click()")
    selected = chromium.run("(({ value, selectionStart, selectionEnd }) => value.slice(selectionStart, selectionEnd))(document.querySelector('rt-picture').editor)")
    if selected != wrong[0].splitlines()[-1]:
        errors.append(f"selected is {selected!r}")
    goes_on("the selection")
    def many(count):
        return show(chromium, f"figure.scene = `{good}` + Array.from({{ length: {count} }}, (_, i) => `sp ${{i}},0,0 1 1,1,1\\n`).join(''); figure.draw();")

    if "memory" not in (shown := many(700000))["status"]:
        errors.append(f"too many spheres: {shown['status']}")
    goes_on("too many spheres")
    chromium.run("customElements.get('rt-picture').longest = 5")
    if "no picture within" not in (shown := many(50000))["status"]:
        errors.append(f"too long: {shown['status']}")
    chromium.run("customElements.get('rt-picture').longest = 20000")
    goes_on("too long")
    return errors


def main():
    server, origin = serve(Site)
    failed = False
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        chromium = Chromium(folder)
        checks = [(f"stage {stage}", lambda stage=stage: check(chromium, origin, pathlib.Path(folder), stage)) for stage in stages]
        checks.append(("wrong scenes", lambda: check_wrong_scenes(chromium, origin, pathlib.Path(folder))))
        try:
            for name, run in checks:
                begin = time.monotonic()
                errors = run()
                failed = failed or bool(errors)
                print(f"{'FAILED' if errors else 'passed'}  {name}: {time.monotonic() - begin:.1f} s", *errors[:8],
                      sep="\n    " if errors else "")
        finally:
            chromium.process.terminate()
            chromium.process.wait()
    server.shutdown()
    sys.exit(failed)


main()
