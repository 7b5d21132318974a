#!/usr/bin/python3
"""The live figures in Chromium, and in Firefox where that is installed: live_test.py BUILD PROJECT [FIGURE...]

Each figure is loaded, dragged with the mouse and the keyboard through its states in both precisions,
and every answer that it drew must equal the native program's, byte for byte. No console error, and
no request to another host. Status 77 where Chromium or the engine is missing.
"""
import base64
import contextlib
import http.server
import json
import math
import os
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import time

import chromium
import firefox

build, project = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
live = project / "docs/figures/live"
shared = {"content", "drawing", "engine", "mine", "picture", "picture_worker", "words"}
figures = sys.argv[3:] or sorted(file.stem for file in live.glob("*.js") if file.stem not in shared)
engines = {precision: build / f"engine_{precision}" for precision in ["double", "float"]}
for needed in [chromium.program, build / "engine/engine_float.wasm", build / "call_once", *engines.values()]:
    if needed is None or not pathlib.Path(needed).exists():
        print(f"skipped: {needed or 'chromium'} is missing")
        sys.exit(77)

page = """<!doctype html><html lang="en"><meta charset="utf-8"><title>{0}</title><link rel="icon" href="data:,">
<style>:root {{ color-scheme: light dark }} body {{ width: 660px; margin: 8px }}</style>
<rt-{0}><p><img alt="what is drawn"></p></rt-{0}><script type="module" src="/figures/live/{0}.js"></script>"""


class Site(http.server.BaseHTTPRequestHandler):
    """A page for each figure, its files, and the engine."""
    protocol_version = "HTTP/1.1"
    worker = None  # the student's, if there is one

    def log_message(self, *_):
        pass

    def do_GET(self):
        folder, name = os.path.split(self.path)
        types = {".js": "text/javascript", ".wasm": "application/wasm"}
        file = (build / "engine" if name.endswith(".wasm") else live) / name
        status, kind, body = 404, "text/plain", b"not found"
        if folder == "/page":
            status, kind, body = 200, "text/html", page.format(name).encode()
        elif folder == "/figures/live" and name == "mine.js" and self.worker:
            status, kind, body = 200, types[".js"], b'export const mine = "../../own_answer", files = "../../own_files";'
        elif folder == "/figures/live" and file.is_file():
            status, kind, body = 200, types[file.suffix], file.read_bytes()
        elif name == "own_files":
            status, body = 200, str(self.worker).encode()
        elif name.startswith("own_answer?"):  # as common/course/book/book.cpp
            called = subprocess.run([build / "call_once", build / self.worker, name.split("question=")[1]],
                                    stdout=subprocess.PIPE, text=True)
            right = called.returncode == 0
            status, body = (200, bytes.fromhex(called.stdout)) if right else (422, called.stdout.strip().encode())
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        with contextlib.suppress(ConnectionError):  # the page is left
            self.wfile.write(body)


# In the page: the questions and the text of the last drawing, once it is done.
state = """(async () => {
  const figure = document.querySelector("rt-%s");
  for (let i = 0; !figure.table || figure.drawing || figure.moving || !figure.asked; ++i) {
    if (i === 6000) throw Error("the figure does not draw");
    await new Promise((resolve) => setTimeout(resolve, 5));
  }
  const hex = (bytes) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join("");
  return { table: figure.table.textContent, texts: Array.from(figure.svg.querySelectorAll("text"), ({ textContent }) => textContent), shapes: figure.back.querySelectorAll("*").length,
           asked: figure.asked.map(({ precision, question, answer, name }) => [precision, hex(question), hex(answer), name]) };
})()"""


def part(name, script):
    return f'document.querySelector("rt-{name}").shadowRoot.querySelector{script}'


def drag(browser, name, by):
    """Drags the figure's last handle by these pixels, in steps."""
    browser.run(f'document.querySelector("rt-{name}").scrollIntoView()')
    box = browser.run(f"(({{x, y, width, height}}) => [x + width / 2, y + height / 2])({part(name, 'All')}('.handle')"
                       ".item(0).getBoundingClientRect())")
    browser.mouse("mousePressed", *box)
    for share in (0.5, 1):
        browser.mouse("mouseMoved", box[0] + share * by[0], box[1] + share * by[1])
    browser.mouse("mouseReleased", box[0] + by[0], box[1] + by[1])


def press(browser, name, selector, key, times):
    """Presses a key on each element, of which some are disabled or already at their end."""
    browser.run(f"{part(name, f'({json.dumps(selector)})')}.focus()")
    for _ in range(times):
        browser.key(key)


def states_of(browser, name):
    """The figure in six states, with each of its other cases, and in three in a second browser: as loaded, and after each change."""
    has_slider = browser.run(f"{part(name, 'All')}('input[type=range]').length > 0")
    changes = [lambda: None,
               lambda: drag(browser, name, (31, -23)),
               lambda: press(browser, name, ".handle", "ArrowDown", 7),
               lambda: press(browser, name, "input[type=range]" if has_slider else ".handle", "ArrowRight", 3),
               lambda: press(browser, name, "input[value=double]", "ArrowRight", 1),
               lambda: drag(browser, name, (-17, 29))]
    cases = browser.run(f"{part(name, 'All')}('button').length")
    changes += [lambda case=case: browser.run(f"{part(name, 'All')}('button')[{case}].click()") for case in range(cases)]
    if not isinstance(browser, chromium.Chromium):
        changes = [changes[0], changes[1], changes[4]]  # which a second browser could do otherwise
    for change in changes:
        change()
        yield browser.run(state % name)


def native(precision, questions):
    """The native program's answers, as text in hexadecimal digits."""
    given = b"".join(struct.pack("<I", len(question)) + question for question in map(bytes.fromhex, questions))
    output = subprocess.run([engines[precision]], input=given, stdout=subprocess.PIPE, check=True).stdout
    answers, place = [], 0
    while place < len(output):
        size = struct.unpack_from("<I", output, place)[0]
        answers.append(output[place + 4:place + 4 + size].hex())
        place += 4 + size
    return answers


# The C libraries' sine, cosine and tangent differ in the last bit; other functions call none of them.
by_angle = {"explain_screen of stage 0", "image_to_world of stage 0", "camera_ray of stage 1", "sample_light of stage 11"}
# A leaf has as many triangles in float as a vector has floats: on some processors eight, in WebAssembly four.
by_width = ("float", "owl_hierarchy of stage 0")
decimal = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def explanation(answer):
    return bytes.fromhex(answer)[4:].decode(errors="replace")


def nearly_same(precision, function, answer, right):
    """Whether two answers have the same numbers, but for a few units in the last place, and the same words."""
    kind, size, unit = ("f", 4, 2**-23) if precision == "float" else ("d", 8, 2**-52)
    if function.startswith("explain"):
        texts = explanation(answer), explanation(right)
        if decimal.sub("", texts[0]) != decimal.sub("", texts[1]):
            return False
        numbers = [[float(number) for number in decimal.findall(text)] for text in texts]
    elif len(answer) != len(right) or len(right) % (2 * size) != 0:
        return False
    else:
        numbers = [[number for number, in struct.iter_unpack(f"<{kind}", bytes.fromhex(text))] for text in (answer, right)]
    return all(abs(a - b) <= 4 * unit * max(map(abs, numbers[1])) for a, b in zip(*numbers))


def check(browser, origin, name):
    """Errors of one figure, and the number of answers that were compared."""
    errors, seen, count = [], [], {"double": 0, "float": 0}
    browser.events.clear()
    browser.open(f"{origin}/page/{name}")
    browser.run(f"customElements.whenDefined('rt-{name}').then(() => 0)")
    browser.run(state % name)
    errors += check_look(browser, name) + cut_off(browser, name)
    texts = set()
    for number, shown in enumerate(states_of(browser, name)):
        texts.update(shown["texts"])
        if not shown["asked"] or shown["shapes"] < 3:
            errors.append(f"state {number} asks or draws nothing")
        seen.append(json.dumps([shown["asked"], shown["table"]]))
        if number >= 6:  # a case
            errors += [f"state {number}: {error}" for error in cut_off(browser, name)]
        for precision in count:
            asked = [each for each in shown["asked"] if each[0] == precision]
            count[precision] += len(asked)
            expected = native(precision, [question for _, question, _, _ in asked]) if asked else []
            for (_, _, answer, function), right in zip(asked, expected, strict=True):
                if (answer != right and (precision, function) != by_width
                        and not (function in by_angle and nearly_same(precision, function, answer, right))):
                    errors.append(f"state {number}, {precision}: {function} answers {answer}, native {right}")
            # The last explanation is the one that stands in the table, line by line.
            explained = [answer for _, _, answer, function in asked if function.startswith("explain")]
            for line in explanation(explained[-1]).splitlines() if explained and name != "triangle_shared_edge" else []:
                value = line.split(" = ")[-1].strip()
                if value not in shown["table"]:
                    errors.append(f"state {number}, {precision}: the table lacks {line.strip()}")
    errors += says_not(texts, says_of_cases.get(name, [])) if isinstance(browser, chromium.Chromium) else []
    errors += [f"state {i} is the same as the one before" for i in range(1, len(seen)) if seen[i] == seen[i - 1]]
    errors += [f"nothing was asked in {precision}" for precision in count if count[precision] == 0]
    errors += check_finger(browser, name)
    errors += browser.complaints(origin)
    return errors, count


def check_own_answers(browser, origin):
    """Errors of the figure of stage 3 with a student's file, right, wrong and worse."""
    errors = []
    for worker, expected in [("step03_sphere_reference_worker", None), ("wrong/flattened", "≠"),
                             ("wrong/crashes", "your code crashed: "), ("wrong/throws", "your code threw an exception: "),
                             ("wrong/never_answers", "your code gave no answer within ")]:
        if not (build / worker).exists():
            continue
        Site.worker = worker
        browser.open(f"{origin}/page/sphere_roots")
        browser.run("customElements.whenDefined('rt-sphere_roots').then(() => 0)")
        browser.run(state % "sphere_roots")
        press(browser, "sphere_roots", "input[value=reference]", "ArrowLeft", 1)  # from the first to the last: both
        shown = browser.run(state % "sphere_roots")["table"]
        if (expected or "≠") not in shown if expected else "≠" in shown:
            errors.append(f"{worker}: expected {expected or 'no difference'} in {shown}")
    # The page draws again by itself when a file is saved.
    Site.worker = "step03_sphere_reference_worker"
    try:
        browser.run("""(async () => {
          for (let i = 0; document.querySelector("rt-sphere_roots").table.textContent.includes("≠"); ++i) {
            if (i === 400) throw Error("a saved file is not drawn");
            await new Promise((resolve) => setTimeout(resolve, 20));
          }
        })()""")
    except RuntimeError as error:
        errors.append(str(error))
    Site.worker = None
    return errors


# What the figure says as loaded, by hand: 1 is 1 / 0.35 steps of 0.35 above the ground; the areas of (1.1, 0.72) against that of
# abc; 0.6¹³ < 1/512; p = 0.6678 of the light is seen, by integration; √(p (1 − p) / 64) is 0.059.
says = {"sphere_roots": ["0 < t1 < t2: from outside", "t1", "t2"], "cylinder_both_roots": ["B", "zp > h / 2 at t1: t2 is hit"],
        "plane_horizon": ["t = 2.857", "t = −1", "lost"], "cone_side": ["D", "along the side a = 0: one root"], "box_slabs": ["A", "they overlap: in the box"],
        "shadow_offset": ["wrong: no shadow", "wrong: acne"], "triangle_areas": ["α = −0.46", "|α| + |β| + |γ| = 1.92"], "square_frame": ["x = 0.5", "u = 0.75"],
        "phong_vectors": ["N", "L", "R", "V", "θ", "α"], "mirror_facing": ["0.0013 < 1/512"], "soft_shadow_samples": ["true share, by 8192 rays: 0.668", re.compile("typical error: 0.0(5[3-9]|6[0-5])$")],
        "unnormalized_x": ["as printed: 0.5"], "screen_side_view": ["tan(FOV/2) = 0.5774"]}

# What it says when a case is chosen: 1.9 = 0.7 t ± √(1 − 0.5²); the rim is passed at x = −1, and x = 1 is at t = 3 / 0.5; the box is
# left at x = 1, 3.1 = 1.2 t.
says_of_cases = {"sphere_roots": ["t1 = 1.477", "t2 = 3.951"], "cylinder_both_roots": ["hit: t = 6", "t1 = 2, zp = 1.45"],
                 "cone_side": ["steeper than the side"], "box_slabs": ["in the box: 0.9167 ≤ t ≤ 2.583"]}


def says_not(shown, texts):
    return [f"it does not say {text}" for text in texts if not any(text.search(each) if isinstance(text, re.Pattern) else text == each for each in shown)]


def cut_off(browser, name):
    """Errors of texts that reach out of the drawing as it stands, in a wide window and, in Chromium, in one of 400 pixels."""
    errors = []
    for width in [700, 400] if isinstance(browser, chromium.Chromium) else []:
        browser.call("Emulation.setDeviceMetricsOverride", width=width, height=900, deviceScaleFactor=1, mobile=False)
        errors += [f"in {width} pixels, {text} is cut off" for text in browser.run(f"""(async () => {{
          const figure = document.querySelector("rt-{name}"), {{ svg, constructor: {{ height }} }} = figure;
          await figure.redraw();
          return Array.from(svg.querySelectorAll("text")).map((text) => [text.textContent, text.getBBox()])
            .filter(([, box]) => box.x < -4 || box.x + box.width > 644 || box.y < -4 || box.y + box.height > height + 4).map(([text]) => text);
        }})()""")]
    if isinstance(browser, chromium.Chromium):
        browser.call("Emulation.clearDeviceMetricsOverride")
    return errors


def check_look(browser, name):
    """Errors of what a finger may do, of digits, and of names for a screen reader, in the figure as loaded."""
    found = browser.run(f"""(() => {{
      const figure = document.querySelector("rt-{name}"), action = (element) => getComputedStyle(element).touchAction;
      return {{ page: action(figure.svg), handles: figure.handles.map(({{ knob }}) => action(knob)), name: figure.svg.getAttribute("aria-label"),
               open: figure.table.parentElement?.open ?? true, texts: Array.from(figure.svg.querySelectorAll("text"), ({{ textContent }}) => textContent) }};
    }})()""")
    errors = [] if found["page"] == "auto" and set(found["handles"]) == {"none"} else ["a finger cannot scroll the page, or drags no handle"]
    errors += [] if found["name"] == "what is drawn" else [f"its name is {found['name']}"]
    errors += ["all digits are unfolded"] if found["open"] else []
    return errors + says_not(found["texts"], says.get(name, [])) + [f"more than four digits: {text}" for text in found["texts"] if re.search(r"\.0*[1-9]\d{4}", text)]


def check_finger(browser, name):
    """Errors of a finger in Chromium: a handle follows it and the page stays; elsewhere the page follows."""
    if not isinstance(browser, chromium.Chromium):
        return []
    browser.call("Emulation.setDeviceMetricsOverride", width=700, height=200, deviceScaleFactor=1, mobile=False)
    browser.call("Emulation.setTouchEmulationEnabled", enabled=True)
    knob = part(name, "('.handle')")
    places = f"""(() => {{
      const {{ x, y, width }} = {knob}.getBoundingClientRect();
      return [[x + width / 2, y + width / 2], [12, 120], scrollY];
    }})()"""
    browser.run(f"{knob}.scrollIntoView({{ block: 'center' }})")
    handle, margin, page = browser.run(places)

    def swipe(x, y):
        for kind, way in [("touchStart", 0), *(("touchMove", way) for way in range(8, 49, 8))]:
            browser.call("Input.dispatchTouchEvent", type=kind, touchPoints=[{"x": x + way / 2, "y": y - way}])
        browser.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
        return browser.run(f"new Promise((done) => requestAnimationFrame(() => setTimeout(done, 50))).then(() => {places})")

    moved, _, still = swipe(*handle)
    errors = [] if still == page and math.dist(moved, handle) > 3 else [f"a finger drags a handle from {handle} to {moved}, and the page by {still - page}"]
    browser.run("scrollTo(0, 0)")
    errors += [] if swipe(*margin)[2] > 0 else ["a finger does not scroll the page"]
    browser.call("Emulation.setTouchEmulationEnabled", enabled=False)
    browser.call("Emulation.clearDeviceMetricsOverride")
    return errors


def take_shots(browser, name):
    """The figure as it stands, in light and dark, in the folder SHOTS."""
    for scheme in ["light", "dark"] if "SHOTS" in os.environ and isinstance(browser, chromium.Chromium) else []:
        browser.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        shot = browser.call("Page.captureScreenshot", format="png")["data"]
        pathlib.Path(os.environ["SHOTS"], f"{name}_{scheme}.png").write_bytes(base64.b64decode(shot))


def check_all(browser, origin):
    """Whether all figures passed in this browser."""
    passed = True

    def report(errors, what):
        nonlocal passed
        passed = passed and not errors
        print(f"{'FAILED' if errors else 'passed'}  {type(browser).__name__}, {what}", *errors[:8], sep="\n    ")

    for name in figures:
        begin = time.monotonic()
        errors, count = check(browser, origin, name)
        report(errors, f"{name}: {count['double']} answers in double, {count['float']} in float, {time.monotonic() - begin:.1f} s")
        take_shots(browser, name)
    if (build / "step03_sphere_reference_worker").exists():
        report(check_own_answers(browser, origin), "answers of a student's file")
    else:
        print("skipped: answers of a student's file, as step03_sphere_reference_worker is not built")
    return passed


def main():
    server, origin = chromium.serve(Site)
    browsers = [chromium.Chromium]
    if firefox.missing:
        print(f"skipped: in Firefox, as {firefox.missing} is missing")
    else:
        browsers.append(firefox.Firefox)
    passed = True
    for kind in browsers:
        with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
            browser = kind(folder)
            try:
                passed = check_all(browser, origin) and passed
            finally:
                browser.process.terminate()
                browser.process.wait()
    server.shutdown()
    sys.exit(not passed)


main()
