// Stage 13: a box as the common part of its slabs. Drag the ray: it is inside where all intervals are.
import { RayFigure, ahead, at, color, define, short, toward } from "./drawing.js";

const box = { min: [-1.2, -0.8, -1], max: [1.2, 0.8, 1] };
const oriented = { center: [0, 0, 0], basis: { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] }, half_size: [1.2, 0.8, 1] };

define("box_slabs", class extends RayFigure {
  view = { place: [320, 150], scale: 80 };
  static height = 366;

  setup() {
    super.setup();
    this.cases({ "A: in the box": toward([-2.6, -0.9, 0], [1.1, 0.45, 0]), "B: no common t": toward([-2.4, 0.35, 0], [1.1, 1.1, 0]), "C: behind": toward([1.7, -0.95, 0], [0.7, -0.5, 0]) });
  }

  async draw(sketch) {
    const { ray } = this;
    const explanation = await this.ask(0, "explain", ray, oriented, ahead);
    const inside = await this.ask(13, "overlap", ray, box, { min: -Infinity, max: Infinity });
    const t = await this.ask(13, "intersect", ray, oriented, ahead);
    sketch.polygon([[-1.2, -5, 0], [1.2, -5, 0], [1.2, 5, 0], [-1.2, 5, 0]], { fill: color.pale_blue });
    sketch.polygon([[-5, -0.8, 0], [-5, 0.8, 0], [5, 0.8, 0], [5, -0.8, 0]], { fill: color.pale_green });
    sketch.polygon([[-1.2, -0.8, 0], [1.2, -0.8, 0], [1.2, 0.8, 0], [-1.2, 0.8, 0]], { fill: color.tint, stroke: color.ink, width: 2 });
    sketch.ray(ray);
    if (inside !== null) sketch.line(at(ray, inside.min), at(ray, inside.max), { stroke: color.red, width: 4 });
    const n = t === null ? null : await this.ask(13, "normal", oriented, at(ray, t));
    if (t !== null) {
      this.normal(sketch, at(ray, t), n);
      sketch.mark(at(ray, t), "hit");
      sketch.label(at(ray, t), [12, 22], `$t$ = ${short(t)}`, color.red, "start");
    }
    // The intervals of t, below one another; t = 0 and 1 are the ray's origin and its direction's tip.
    const number = (text) => Number(text.replace("inf", "Infinity"));
    const limits = Array.from(explanation.matchAll(/planes of (.) = \((.*), (.*)\)/g), ([, name, min, max]) => [name, number(min), number(max)]);
    const place = (time) => 445 + 40 * Math.max(-4.5, Math.min(4.5, time - 1.5));
    sketch.pixels("rect", { x: 0, y: 268, width: 640, height: 98 }, { fill: color.white });
    limits.slice(0, 2).forEach(([name, min, max], i) => {
      const y = 283 + 24 * i;
      if (min <= max) sketch.pixels("line", { x1: place(min), x2: place(max), y1: y, y2: y }, { stroke: i ? color.green : color.blue, width: 7 });
      sketch.shape("text", { x: 22, y: y + 5 }, `between the planes of $${name}$`);
    });
    if (inside !== null) sketch.pixels("line", { x1: place(inside.min), x2: place(inside.max), y1: 331, y2: 331 }, { stroke: color.red, width: 7 });
    sketch.shape("text", { x: 620, y: 361, text_anchor: "end", style: `fill: ${color.red}` }, inside === null ? "no common part" : `${short(inside.min)} ≤ $t$ ≤ ${short(inside.max)}`);
    sketch.shape("text", { x: 22, y: 336 }, "in the box");
    sketch.pixels("line", { x1: place(0), x2: place(0), y1: 275, y2: 345 }, { stroke: color.gray, dashes: "3 3" });
    sketch.shape("text", { x: place(0), y: 361, text_anchor: "middle" }, "$t$ = 0");
    return [explanation, ["overlap", inside], ["intersect", t], ["normal", n]];
  }
});
