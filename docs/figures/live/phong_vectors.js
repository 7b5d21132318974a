// Stage 9: the four vectors at a point of a ball, and the ball as the eye sees it. Drag the light, the
// eye and the point; change the shares.
import { Figure, add, color, define, minus, short, times } from "./drawing.js";

const unit = (v) => times(1 / (Math.hypot(...v) || 1), v);
const [middle, radius] = [[515, 100], 90];  // of the ball as the eye sees it
const outside = (p) => times(Math.max(1.15, Math.hypot(...p)) / (Math.hypot(...p) || 1), p);
const parts = { all: [1, 1, 1], ambient: [1, 0, 0], diffuse: [0, 1, 0], specular: [0, 0, 1] };

/// Pixels in blue, green, red and opacity as the address of a bitmap, which has the same bytes on every machine.
function bitmap(pixels, side) {
  const bytes = new Uint8Array(54 + 4 * side * side), view = new DataView(bytes.buffer);
  bytes.set([0x42, 0x4d]);
  [[2, bytes.length], [10, 54], [14, 40], [18, side], [22, -side]].forEach(([place, value]) => view.setInt32(place, value, true));
  bytes.set([1, 0, 32], 26);  // one plane, 32 bits a pixel
  bytes.set(pixels, 54);
  let text = "";
  for (let i = 0; i < bytes.length; i += 3000) text += String.fromCharCode(...bytes.subarray(i, i + 3000));
  return `data:image/bmp;base64,${btoa(text)}`;
}

define("phong_vectors", class extends Figure {
  static height = 372;
  view = { place: [205, 255], scale: 105 };  // a slice through the ball, the light and the eye

  setup() {
    this.light = this.handle("light", undefined, { fill: color.amber, keep: outside });
    this.eye = this.handle("eye", undefined, { fill: color.blue, keep: outside });
    this.point = this.handle("point", undefined, { fill: color.red, keep: unit });
    this.ambient = this.slider("ambient", { min: 0, max: 1, step: 0.05, value: 0.25 });
    this.specular = this.slider("k_s", { min: 0, max: 1, step: 0.05, value: 0.6 });
    this.shininess = this.slider("n", { min: 1, max: 256, step: 1, value: 8 });
    const places = (light, eye) => ({ light, eye, point: [0, 1, 0] });
    this.cases({ "α > 0": places([-0.75, 2.2, 0], [1.5, 2, 0]), "α = 0": places([-1, 2, 0], [1, 2, 0]), "θ > 90°": places([-1.3, 0.75, 0], [1.5, 2, 0]) });
    this.term = this.choice("term", Object.keys(parts));
    // Behind the drawing, as a picture in it takes the browser longer than a frame.
    const [cx, cy] = middle, share = (x, whole) => `${(100 * x) / whole}%`;
    this.canvas = document.createElement("canvas");
    Object.assign(this.canvas.style, { left: share(cx - radius, 640), top: share(cy - radius, this.constructor.height), width: share(2 * radius, 640) });
    this.svg.before(this.canvas);
  }

  angle(sketch, p, from, to, size, name, stroke) {
    const start = Math.atan2(from[1], from[0]), turn = Math.atan2(from[0] * to[1] - from[1] * to[0], from[0] * to[0] + from[1] * to[1]);
    const on = (share, r) => add(p, [r * Math.cos(start + share * turn), r * Math.sin(start + share * turn), 0]);
    sketch.polyline(Array.from({ length: 17 }, (_, i) => on(i / 16, size)), { stroke, width: 1 });
    sketch.label(on(0.5, size + 0.12), [0, 5], `$${name}$`, stroke);
  }

  /// The ball in the screen's own pixels, or with a third of them in a row while something moves.
  async draw_ball(sketch, light, ambient, material, to_eye) {
    const sharp = Math.ceil((2 * radius * this.svg.getBoundingClientRect().width * devicePixelRatio) / 640) || 64;
    const side = Math.min(this.moving ? 64 : 600, sharp), [cx, cy] = middle;
    const pixels = await this.ask(0, "lit_ball", light, ambient, material, to_eye, side);
    this.canvas.hidden = !this.moving;
    if (this.moving) {
      const image = new ImageData(side, side);
      pixels.forEach((value, i) => (image.data[i % 2 ? i : i ^ 2] = value));  // red is first
      Object.assign(this.canvas, { width: side, height: side }).getContext("2d").putImageData(image, 0, 0);
    } else sketch.shape("image", { href: bitmap(pixels, side), x: cx - radius, y: cy - radius, width: 2 * radius, height: 2 * radius, clip_path: "circle(50%)" });
    sketch.pixels("circle", { cx, cy, r: radius }, { stroke: color.gray });
    sketch.write([cx, 210], "what the eye sees", color.ink, "middle");
    // The point as the eye sees it, if it does.
    const p = this.point.place;
    if (p[0] * to_eye[0] + p[1] * to_eye[1] > 0) sketch.pixels("circle", { cx, cy: cy - radius * (p[1] * to_eye[0] - p[0] * to_eye[1]), r: 5 }, { fill: color.red, stroke: color.white });
  }

  async draw(sketch) {
    const p = this.point.place, to_eye = unit(minus(this.eye.place, p));
    const [ratio, brightness, highlight] = parts[this.term.value];
    const material = { color: [0.35, 0.55, 0.85], specular: this.specular.value, shininess: this.shininess.value, mirror: 0 };
    const light = { position: this.light.place, brightness: 0.9, color: [1, 1, 1], radius: 0 }, ambient = { ratio: this.ambient.value, color: [1, 1, 1] };
    sketch.circle([0, 0, 0], 1);
    const N = p[0] * to_eye[0] + p[1] * to_eye[1] < 0 ? times(-1, p) : p;  // on the side of the eye
    const surface = { point: p, normal: N, geometric_normal: N, to_eye, error: 0, material };
    const L = unit(minus(this.light.place, p)), R = await this.ask(9, "reflected", L, N);
    const terms = { ambient: await this.ask(9, "ambient_term", surface, ambient), diffuse: await this.ask(9, "diffuse_term", surface, light), specular: await this.ask(9, "specular_term", surface, light) };
    sketch.line(p, this.light.place, { stroke: color.amber, width: 1, dashes: "4 4" });
    sketch.line(p, this.eye.place, { stroke: color.blue, width: 1, dashes: "4 4" });
    for (const [name, v, stroke] of [["N", N, color.green], ["L", L, color.amber], ["R", R, color.amber], ["V", to_eye, color.blue]]) {
      sketch.arrow(p, add(p, v), { stroke, width: 2.2 });
      const beside = name === "R" && v[0] * to_eye[0] + v[1] * to_eye[1] > 0.97;  // V is there
      sketch.label(add(p, times(beside ? 0.85 : 1.13, v)), beside ? [16 * v[1], 5 + 16 * v[0]] : [0, 5], `$${name}$`, stroke);
    }
    this.angle(sketch, p, N, L, 0.36, "θ", color.ink);
    this.angle(sketch, p, N, R, 0.42, "θ", color.ink);
    this.angle(sketch, p, R, to_eye, 0.62, "α", color.ink);
    sketch.label(p, [0, 26], "$p$", color.red);
    for (let i = 0; i < 8; ++i) {  // a small sun, and an eye
      const beam = [Math.cos((i * Math.PI) / 4), Math.sin((i * Math.PI) / 4), 0];
      sketch.line(add(this.light.place, times(0.1, beam)), add(this.light.place, times(0.15, beam)), { stroke: color.amber, width: 2 });
    }
    sketch.circle(this.light.place, 0.07, { fill: color.pale_amber, stroke: color.amber });
    const across = [-to_eye[1], to_eye[0], 0];
    sketch.polyline([-0.09, 0, 0.09].map((x) => add(this.eye.place, add(times(x, across), times(x ? 0 : 0.15, to_eye)))), { width: 2 });
    sketch.circle(add(this.eye.place, times(0.04, to_eye)), 0.04, { fill: color.ink });
    sketch.label(this.light.place, [-20, 5], "light", color.ink, "end");
    sketch.label(this.eye.place, [20, 5], "eye", color.ink, "start");
    const shown = { ...material, color: times(Math.max(ratio, brightness), material.color), specular: highlight * material.specular };
    await this.draw_ball(sketch, { ...light, brightness: Math.max(brightness, highlight) * light.brightness }, { ...ambient, ratio: ratio * ambient.ratio }, shown, to_eye);
    const cosine = (a, b) => short(a.reduce((sum, x, i) => sum + x * b[i], 0));
    const told = { ambient: ["", color.gray], diffuse: [`, cos $θ$ = ${cosine(L, N)}`, color.amber], specular: [`, cos $α$ = ${cosine(R, to_eye)}`, color.amber] };
    Object.entries(told).forEach(([term, [angle, fill]], i) => {
      const y = 242 + 36 * i;
      sketch.cells([[400, y + 6, 200 * Math.min(1, terms[term][2]), 12]], { fill });
      sketch.write([400, y], `${term}: ${short(terms[term][2])}${angle}`);
    });
    return [await this.ask(0, "explain_light", surface, light), ...Object.entries(terms)];
  }
});
