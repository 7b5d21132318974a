// The base of all live figures: a sketch to draw on, handles to drag, sliders, and the rows of
// numbers below. A figure computes nothing that a stage teaches: it calls the stages' functions.
import { has_mine, open } from "./engine.js";
import { tr } from "./words.js";

// As docs/figures/source/svg.hpp, and with the same meaning in all figures: blue is a ray, red a hit, green a normal or an axis,
// amber light, purple what is wrong. Each has its twin on a dark page; draw_live.py writes both into an SVG file.
const pair = (light, dark) => `light-dark(${light}, ${dark})`;
export const color = {
  white: pair("#fff", "#0d1117"), ink: pair("#24292f", "#e6edf3"), gray: pair("#68707a", "#9da7b3"), faint: pair("#d3d9e0", "#3b434d"),
  tint: pair("#edf2f7", "#1b222b"), blue: pair("#1f6bad", "#4da3e6"), red: pair("#c23b22", "#f0694d"), green: pair("#35784a", "#5fb878"),
  amber: pair("#a86500", "#d99a2b"), purple: pair("#7a3b99", "#c792ea"), pale_blue: pair("#d5e5f3", "#1d3a54"), pale_red: pair("#f6dcd6", "#54271e"),
  pale_green: pair("#d9ebdf", "#1f4229"), pale_amber: pair("#f8e3b8", "#54400f"),
};

const style = `
  :host { display: block; margin: 1em 0; }
  div { position: relative; max-width: 640px; background: ${color.white}; }
  svg { width: 100%; display: block; position: relative; font: 14px sans-serif; }
  canvas { position: absolute; }
  svg text { fill: ${color.ink}; stroke: ${color.white}; stroke-width: 4; stroke-linejoin: round; paint-order: stroke; }
  .handle { display: block; cursor: grab; outline: none; touch-action: none; stroke: ${pair("#24292f40", "#e6edf350")}; stroke-width: 8; paint-order: stroke; }
  .handle:hover { stroke: ${pair("#24292f70", "#e6edf380")}; }
  .handle:active { cursor: grabbing; }
  .handle:focus { stroke: ${color.amber}; }
  button { font: inherit; color: inherit; background: ${color.tint}; border: 1px solid ${color.gray}; border-radius: 5px; padding: .2em .7em; min-height: 26px; cursor: pointer; }
  button[aria-pressed=true] { background: ${color.pale_blue}; border-color: ${color.blue}; }
  summary { font: 14px sans-serif; color: ${color.ink}; cursor: pointer; width: max-content; min-height: 24px; }
  form { font: 14px sans-serif; display: flex; flex-wrap: wrap; gap: .3em 1.2em; align-items: center; margin: .5em 0; color: ${color.ink}; }
  label, fieldset { display: inline-flex; flex-wrap: wrap; align-items: center; gap: .4em; min-height: 24px; }
  fieldset { border: 0; padding: 0; margin: 0; }
  input { accent-color: ${color.blue}; }
  input[type=range] { width: 11em; }
  output { min-width: 4.5em; font-family: monospace; }
  table { font: 13px/1.5 monospace; border-collapse: collapse; color: ${color.ink}; display: block; max-width: 640px; overflow-x: auto; }
  td { padding: 0 1em 0 0; vertical-align: top; }
  td:first-child:not([colspan]) { white-space: nowrap; }
  td[colspan="2"] { color: ${color.gray}; }
  .differs { color: ${color.red}; font-weight: bold; }
  @media (max-width: 500px) { svg { font-size: 19px; } .long { font-size: 15px; } input[type=range] { width: 7em; } td:first-child:not([colspan]) { white-space: normal; } .handle { stroke-width: 24; } }
  slot { display: none; }
  @media print { slot { display: block; } div, form, details { display: none; } }`;  // the drawn figure

export const add = (a, b) => a.map((x, i) => x + b[i]);
export const minus = (a, b) => a.map((x, i) => x - b[i]);
export const times = (s, v) => v.map((x) => s * x);
export const at = (ray, t) => add(ray.origin, times(t, ray.direction));
export const ahead = { min: 0, max: Infinity };
const along = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
const plain = (x) => Number(x.toPrecision(4));
/// A number as it stands in a drawing: four digits. All are in the table.
export const short = (x, digits = 4) => String(Number(x.toPrecision(digits))).replace("-", "−");

/// Between two $, as svg.hpp says: "_" lowers the next letter, and a letter is italic.
function typeset(made, text) {
  let low = 0;
  text.split("$").forEach((part, i) => {
    for (const [, lowered, letter, other] of part.matchAll(i % 2 ? /_(.)|(\p{L})|([^_\p{L}]+)/gu : /()()([^]+)/g)) {
      const dy = lowered ? 4 : 0, style = `${/\p{L}/u.test(lowered || letter) ? "font-style: italic; " : ""}font-size: ${lowered ? "75%" : "inherit"}`;
      const span = element("tspan", { dy: dy - low, style });
      span.textContent = lowered || letter || other;
      made.append(span);
      low = dy;
    }
  });
}

/// The same as plain text.
const unset = (text) => text.replaceAll("$", "").replace(/_(\d)/g, (_, digit) => String.fromCodePoint(0x2080 + Number(digit)));

function element(name, attributes) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key.replace("_", "-"), value);
  return made;
}

/// Makes the elements of a group those of a list. What is the same stays: each change takes a part of a frame's time.
function show(group, shapes) {
  const shown = group.shapes ?? [], likeness = ({ name, attributes, text }) => [name, ...Object.keys(attributes), text].join();
  shapes.forEach((shape, i) => {
    const { name, attributes, text } = shape, old = shown[i];
    if (old && likeness(old) === likeness(shape)) {
      shape.made = old.made;
      for (const key in attributes) if (attributes[key] !== old.attributes[key]) shape.made.setAttribute(key.replace("_", "-"), attributes[key]);
      return;
    }
    shape.made = element(name, attributes);
    if (name === "svg") shape.made.innerHTML = text;
    else typeset(shape.made, text);
    if (old) old.made.replaceWith(shape.made);
    else group.append(shape.made);
  });
  shown.slice(shapes.length).forEach(({ made }) => made.remove());
  group.shapes = [...shapes];
}

/// A page of vector graphics; points in space, projected along the view.
export class Sketch {
  constructor(group, labels, view) {
    [this.group, this.labels] = [group, labels];
    this.view = { scale: 100, right: [1, 0, 0], up: [0, 1, 0], ...view };
  }
  screen(point) {
    const { place, scale, right, up } = this.view;
    return [place[0] + scale * along(point, right), place[1] - scale * along(point, up)];
  }
  world([x, y]) {
    const { place, scale, right, up } = this.view;
    return add(times(plain((x - place[0]) / scale), right), times(plain((place[1] - y) / scale), up));
  }
  shape(name, attributes, text = "") {
    (name === "text" ? this.labels : this.group).push({ name, attributes, text });  // labels are over everything else
  }
  /// Rectangles of one color, as places and sizes in pixels.
  cells(all, pen) {
    if (all.length) this.pixels("path", { d: all.map(([x, y, width, height]) => `M${x} ${y}h${width}v${height}h${-width}z`).join("") }, pen);
  }
  /// A text at a place in pixels.
  write([x, y], english, fill = color.ink, anchor = "start", style = "") {
    const text = tr(english);
    this.shape("text", { x, y, text_anchor: anchor, style: `fill: ${fill}${style}`, class: unset(text).length > 18 ? "long" : "" }, text);
  }
  pixels(name, attributes, { stroke = "none", fill = "none", width = 1.5, dashes = "none" } = {}, text = "") {
    this.shape(name, { ...attributes, stroke, fill, stroke_width: width, stroke_dasharray: dashes }, text);
  }
  line(from, to, pen = {}) {
    const [[x1, y1], [x2, y2]] = [this.screen(from), this.screen(to)];
    this.pixels("line", { x1, y1, x2, y2 }, { stroke: color.ink, ...pen });
  }
  arrow(from, to, pen = {}) {
    const [a, b] = [this.screen(from), this.screen(to)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]);
    if (length < 1) return;
    const [x, y] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length], head = Math.min(length, 5 + 3 * (pen.width ?? 1.5));
    const [foot, side] = [[b[0] - head * x, b[1] - head * y], [-0.38 * head * y, 0.38 * head * x]];
    this.pixels("line", { x1: a[0], y1: a[1], x2: foot[0], y2: foot[1] }, { stroke: color.ink, ...pen });
    this.pixels("polygon", { points: [b, add(foot, side), minus(foot, side)].join(" ") }, { fill: pen.stroke ?? color.ink });
  }
  polygon(points, pen = {}) {
    this.pixels("polygon", { points: points.map((point) => this.screen(point)).join(" ") }, pen);
  }
  polyline(points, pen = {}) {
    this.pixels("polyline", { points: points.map((point) => this.screen(point)).join(" ") }, { stroke: color.ink, ...pen });
  }
  circle(center, radius, pen = {}) {
    const [cx, cy] = this.screen(center);
    this.pixels("circle", { cx, cy, r: Math.max(0, radius * this.view.scale) }, { fill: color.tint, stroke: color.ink, ...pen });
  }
  /// "hit": the nearest; "refused": a root that is not it; "given" and "foot". By shape and color.
  mark(point, what) {
    const [cx, cy] = this.screen(point);
    const pens = { hit: [5, { fill: color.red, stroke: color.white, width: 1 }], refused: [4.5, { fill: color.white, stroke: color.red }], given: [3.5, { fill: color.ink, stroke: color.white, width: 1 }], foot: [3, { fill: color.gray, stroke: color.white, width: 1 }] };
    const [r, pen] = pens[what];
    if (Math.abs(cx) < 1e4 && Math.abs(cy) < 1e4) this.pixels("circle", { cx, cy, r }, pen);
  }
  label(point, offset, text, fill = color.ink, anchor = "middle", style = "") {
    this.write(add(this.screen(point), offset), text, fill, anchor, style);
  }
  /// Roots with their t, and `told` of each: the first is labeled above, the last below.
  roots(ray, roots, hit, told = () => "") {
    [...roots].sort((a, b) => a - b).forEach((t, i) => {
      const steep = Math.abs(ray.direction[1]) > 1.5 * Math.abs(ray.direction[0]), up = ray.direction[1] > 0.05 * Math.abs(ray.direction[0]);
      this.mark(at(ray, t), t === hit ? "hit" : "refused");
      const name = roots.length > 1 ? `$t_${i + 1}$` : "$t$", left = !steep && (i === 0 || t < 0);
      this.label(at(ray, t), steep ? [12, 5] : [left ? -10 : 10, left === up ? -10 : 20], `${name} = ${short(t)}${told(t)}`, t === hit ? color.red : color.gray, left ? "end" : "start");
    });
  }
  ray(ray, end = 9, back = end) {
    const length = Math.hypot(...ray.direction) || 1;
    this.line(at(ray, -back / length), ray.origin, { stroke: color.blue, width: 1.2, dashes: "4 4" });
    this.line(ray.origin, at(ray, end / length), { stroke: color.blue });
    this.arrow(ray.origin, at(ray, 1), { stroke: color.blue, width: 3 });
  }
}

/// The base of all figures. A figure has `view`, `setup()` and `draw(sketch)`.
export class Figure extends HTMLElement {
  static height = 340;
  static most_of_mine = 40;  // calls of the student's file, each by another process
  view = { place: [320, 170] };
  mode = "reference";

  async connectedCallback() {
    // The first of a page begins at once, the others when the browser has time.
    const is_first = !Figure.is_begun;
    Figure.is_begun = true;
    this.engine = await open("double");  // without it, the drawn figure stays
    if (!is_first) await new Promise((done) => (window.requestIdleCallback ?? setTimeout)(done));
    const root = this.attachShadow({ mode: "open" });
    root.innerHTML = `<style>${style}</style><slot></slot><div></div><form></form><details><summary>${tr("All digits")}</summary><table></table></details>`;
    [this.form, this.table] = [root.querySelector("form"), root.querySelector("table")];
    this.svg = element("svg", { viewBox: `0 0 640 ${this.constructor.height}`, role: "group" });
    const name = () => this.svg.setAttribute("aria-label", this.querySelector("img")?.alt ?? this.localName);
    addEventListener("DOMContentLoaded", name);  // if it is not yet whole
    name();
    [this.back, this.front] = [element("g", {}), element("g", {})];
    this.svg.append(this.back, this.front);
    root.querySelector("div").append(this.svg);
    this.back.append(element("g", {}), element("g", {}));
    this.sketch = new Sketch([], [], this.view);
    this.setup();
    this.precision = this.choice("precision", ["double", "float"]);
    if (has_mine) this.whose = this.choice("answers", ["reference", "mine", "both"]);
    this.form.addEventListener("submit", (event) => event.preventDefault());
    addEventListener("resize", () => this.redraw());
    if (has_mine) addEventListener("saved", () => this.redraw());
    await this.redraw();
  }

  // ---- what can be moved

  /// A point that is dragged, or moved with the arrow keys by `step` pixels, and with Shift by one.
  /// `keep` returns the nearest allowed point.
  handle(name, place = [0, 0, 0], { fill = color.ink, keep = (point) => point, step: pixels = 6 } = {}) {
    const knob = element("circle", { class: "handle", r: 8, fill, tabindex: 0, role: "slider", "aria-label": tr(name) });
    const handle = { name, place, knob, get value() { return this.place; }, set value(point) { this.place = point; } };
    const within = (x, most) => Math.min(Math.max(x, 10), most - 10);
    const move = (x, y) => {
      handle.place = keep(this.sketch.world([within(x, 640), within(y, this.constructor.height)])).map(plain);
      this.#moves();
    };
    handle.show = () => {
      const [cx, cy] = this.sketch.screen(handle.place);
      for (const [key, value] of Object.entries({ cx, cy, "aria-valuenow": plain(cx), "aria-valuetext": `(${handle.place.map(plain).join(", ")})` })) knob.setAttribute(key, value);
    };
    knob.addEventListener("pointerdown", (event) => knob.setPointerCapture(event.pointerId));
    knob.addEventListener("pointermove", (event) => {
      if (!knob.hasPointerCapture(event.pointerId)) return;
      const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
      move(x, y);
    });
    knob.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[event.key];
      if (!step) return;
      event.preventDefault();
      move(...add(this.sketch.screen(handle.place), times(event.shiftKey && pixels === 6 ? 1 : pixels, step)));
    });
    this.front.append(knob);
    (this.handles ??= []).push(handle);
    return handle;
  }

  /// A number from min to max; with `power`, ten to the power of the slider.
  slider(name, { min, max, step, value, power = false, unit = "" }) {
    const input = Object.assign(document.createElement("input"), { type: "range", min, max, step });
    input.value = value;
    const read = () => (power ? Number((10 ** Number(input.value)).toPrecision(2)) : Number(input.value));
    const output = document.createElement("output");
    const show = () => { output.textContent = (power ? read().toExponential() : read()) + unit; input.setAttribute("aria-valuetext", output.textContent); };
    input.addEventListener("input", () => (show(), this.#moves()));
    show();
    this.#labeled(name, input, output);
    return { get value() { return read(); }, set value(x) { input.value = power ? Math.log10(x) : x; show(); } };
  }

  /// A button for each case, which sets handles and sliders by their names. The figure starts with the case `start`, or
  /// `together`: with all of them, and the handles of `start`.
  cases(all, start = Object.keys(all)[0], together = false) {
    this.all = all;
    const buttons = Object.entries({ ...(together && { all: all[start] }), ...all }).map(([name, values]) => {
      const button = Object.assign(document.createElement("button"), { type: "button", title: unset(tr(name)), textContent: unset(tr(name.split(": ")[0])) });
      button.choose = () => {
        for (const [part, value] of Object.entries(values)) this[part].value = value;
        this.#moved(button, name);
      };
      button.addEventListener("click", button.choose);
      return button;
    });
    this.form.prepend(...buttons);
    this.buttons = buttons;
    (together ? buttons[0] : buttons[Object.keys(all).indexOf(start)]).choose();
  }
  /// While something moves, the table waits if it is folded, and what is shaded is coarser.
  #moves() {
    this.moving = true;
    clearTimeout(this.rest);
    this.rest = setTimeout(() => ((this.moving = false), this.redraw()), 150);
    this.#moved();
  }
  #moved(button = null, name = "") {
    for (const each of this.buttons ?? []) each.setAttribute("aria-pressed", each === button);
    [this.chosen, this.together] = [name, name === "all"];
    if (this.precision) this.redraw();
  }

  check(name, checked = false) {
    const input = Object.assign(document.createElement("input"), { type: "checkbox", checked });
    input.addEventListener("input", () => this.redraw());
    const label = document.createElement("label");
    label.append(input, tr(name));
    this.form.append(label);
    return { get value() { return input.checked; } };
  }

  choice(name, values) {
    const set = document.createElement("fieldset");
    set.setAttribute("aria-label", tr(name));
    for (const value of values) {
      const input = Object.assign(document.createElement("input"), { type: "radio", name, value, checked: value === values[0] });
      const label = document.createElement("label");
      label.append(input, tr(value));
      set.append(label);
    }
    set.addEventListener("input", () => this.redraw());
    this.form.append(set);
    return { get value() { return set.querySelector(":checked").value; } };
  }

  #labeled(name, ...parts) {
    const label = document.createElement("label");
    label.append(tr(name), ...parts);
    this.form.append(label);
  }

  // ---- questions and their answers

  /// A stage's function: the reference's answer, or the student's, which takes a while. Stage 0 are explanations.
  ask(stage, name, ...values) {
    const [question, type] = this.engine.question(stage, name, values), answer = this.engine.reference(question);
    if (!this.moving) this.asked.push({ precision: this.engine.precision, question: question.slice(), answer: answer.slice(), name: `${name} of stage ${stage}` });
    if (stage === 0 || !this.whose || this.whose.value === "reference") return this.engine.read(answer, type);
    return this.#mine(name, question.slice(), answer.slice(), type);
  }
  async #mine(name, question, reference, type) {
    const { most_of_mine } = this.constructor;
    if (++this.own === most_of_mine) this.differences.add(`your file answers the first ${most_of_mine} questions of this figure, the reference the others`);
    if (this.own >= most_of_mine) return this.engine.read(reference, type);
    try {
      const mine = await this.engine.mine(question);
      if (this.whose.value === "both" && mine.join() !== reference.join())
        this.differences.add(`${name}: mine ${JSON.stringify(this.engine.read(mine, type))}, reference ${JSON.stringify(this.engine.read(reference, type))}`);
      return this.engine.read(mine, type);
    } catch (error) {
      this.differences.add(`${name}: ${error.message}`);
      this.own = Infinity;  // who loops would do so for each question
      return this.engine.read(reference, type);
    }
  }

  /// Every t at which the line hits the shape: `intersect`, called again after each answer.
  async roots(stage, ray, shape, min = -Infinity) {
    const found = [];
    for (let t; found.length < 4 && (t = await this.ask(stage, "intersect", ray, shape, { min: found.at(-1) ?? min, max: Infinity })) !== null;) found.push(t);
    return found;
  }

  /// Draws once for all changes that arrived in the meantime.
  async redraw() {
    this.wanted = true;
    if (this.drawing) return;
    this.drawing = true;
    try {
      while (this.wanted) {
        this.wanted = false;
        this.engine = await open(this.precision.value);
        [this.asked, this.differences, this.own] = [[], new Set(), 0];
        [this.sketch.group, this.sketch.labels] = [[], []];
        const rows = await this.draw(this.sketch);
        (this.handles ?? []).forEach((handle) => handle.show());
        this.show();
        if (!this.moving || this.table.parentElement.open) this.#tell([...rows, ...Array.from(this.differences, (text) => ["≠", text, "differs"])]);
      }
    } finally {
      this.drawing = false;
    }
  }

  /// Shows what is in the sketch. A label that would leave the drawing stays at its edge.
  show() {
    const { labels } = this.sketch, into = (start, size, edge, most) => (size > 0 ? Math.max(0, edge - start) + Math.min(0, most - edge - start - size) : 0);
    [this.sketch.group, labels].forEach((shapes, i) => show(this.back.children[i], shapes));
    const boxes = labels.map(({ made }) => made.getBBox());
    labels.forEach(({ made }, i) => [["x", "width", 2, 640], ["y", "height", -3, this.constructor.height]].forEach(([side, size, ...room]) => {
      const by = into(boxes[i][side], boxes[i][size], ...room);
      if (by) made.setAttribute(side, Number(made.getAttribute(side)) + by);
    }));
  }

  /// A row is a name and a value, or a text of `--pixel`.
  #tell(rows) {
    const line = (cells, kind = "") => {
      const row = Object.assign(document.createElement("tr"), { className: kind });
      row.append(...cells.map((text) => Object.assign(document.createElement("td"), { textContent: tr(text), ...(cells.length === 1 && { colSpan: 2 }) })));
      return row;
    };
    if (this.differences.size) this.table.parentElement.open = true;
    this.table.replaceChildren(...rows.flatMap((row) => {
      if (typeof row !== "string") return [line([row[0], typeof row[1] === "string" ? row[1] : said(row[1], this.engine.precision)], row[2])];
      return row.trimEnd().split("\n").map((text) => {
        const [, name, value] = /^ {4}(?!→)(.*) = (.*)$/.exec(text) ?? [];
        return line(name === undefined ? [text.trim()] : [name, value]);
      });
    }));
  }
}

/// A figure of a ray: its origin and the tip of its direction are handles.
export class RayFigure extends Figure {
  setup() {
    this.origin = this.handle("origin");
    this.tip = this.handle("direction", undefined, { fill: color.blue });
  }
  get ray() {
    return { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
  }
  /// The rays to draw, by their names: all cases, as in print, or the one that was chosen or moved.
  get rays() {
    if (!this.together) return { "": this.ray };
    return Object.fromEntries(Object.entries(this.all).map(([name, { origin, tip }]) => [name, { origin, direction: minus(tip, origin) }]));
  }
  /// The normal of a hit, half a unit long, or shorter.
  normal(sketch, p, n, length = 0.5) {
    sketch.arrow(p, add(p, times(length, n)), { stroke: color.green, width: 2 });
  }
  /// Each ray with its roots, and the t and the normal of its hit, as `look` returns them. One ray has its numbers, and what is
  /// `told` of each root; of several, each has its letter, and a line of the key, which begins at `key`, where there is one.
  async draw_rays(sketch, look, { key, told, end = () => 4.2 } = {}) {
    for (const [i, [name, given]] of Object.entries(this.rays).entries()) {
      const { roots, t, n, ray = given } = await look(given), [letter, ...meaning] = name.split(": ");
      const length = Math.hypot(...given.direction), last = Math.max(end(given), ...roots.map((root) => root * length + 0.25).filter((x) => x < 6));
      if (!name) sketch.ray(given);
      else sketch.arrow(given.origin, at(given, last / length), { stroke: color.blue, width: 1.8 });
      if (t !== null) this.normal(sketch, at(ray, t), n);
      if (!name && key && this.chosen) sketch.write([620, this.constructor.height - 14], this.chosen, color.ink, "end");
      if (!name) return sketch.roots(ray, roots, t, told);
      sketch.mark(given.origin, "given");
      for (const root of roots) sketch.mark(at(ray, root), root === t ? "hit" : "refused");
      if (!key && roots.length === 2) [1, 2].forEach((root) => sketch.label(at(ray, roots[root - 1]), [root === 1 ? 10 : -10, -8], `$t_${root}$`, color.red));
      if (!key) continue;
      sketch.label(given.origin, [-14, 5], letter, color.blue, "middle", "; font-weight: bold");
      sketch.write(add(key, [0, 38 * i]), letter, color.blue, "middle", "; font-weight: bold");
      sketch.write(add(key, [18, 38 * i]), meaning.join(": "));
    }
  }
}
/// A case of it.
export const toward = (origin, direction, more) => ({ origin, tip: add(origin, direction), ...more });

/// A value of an answer: a number as its shortest digits. In float, those of a float.
export function said(value, precision = "double") {
  if (value === null) return "nothing";
  if (Array.isArray(value)) return `(${value.map((part) => said(part, precision)).join(", ")})`;
  if (typeof value === "object") return Object.entries(value).map(([name, part]) => `${name} ${said(part, precision)}`).join(", ");
  if (typeof value !== "number" || precision === "double") return String(value);
  for (let digits = 1; digits < 9; ++digits) {
    const short = Number(value.toPrecision(digits));
    if (Math.fround(short) === value) return String(short);
  }
  return String(value);
}

export const define = (name, figure) => customElements.define(`rt-${name}`, figure);
