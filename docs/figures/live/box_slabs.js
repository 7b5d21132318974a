// Stage 13: a box as the common part of its slabs. Drag the ray: it is inside where all intervals are.
import { RayFigure, ahead, at, color, define, short, toward } from "./drawing.js";

const box = { min: [-1, -0.6, -1], max: [1, 0.6, 1] };
const oriented = { center: [0, 0, 0], basis: { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] }, half_size: box.max };
const line = { min: -Infinity, max: Infinity };
const slabs = [0, 1].map((axis) => Object.fromEntries(Object.entries(box).map(([end, corner]) => [end, corner.map((x, i) => (i === axis ? x : 100 * x))])));

define("box_slabs", class extends RayFigure {
  static height = 390;
  view = { place: [176, 190], scale: 72 };

  setup() {
    super.setup();
    this.cases({ "A: they overlap: in the box": toward([-2.1, -1, 0], [1.2, 0.6, 0]), "B: out of $y$ before into $x$: a miss": toward([-2.1, 0.35, 0], [1.1, 1.1, 0]), "C: they overlap at $t$ < 0: behind": toward([1.5, -0.85, 0], [0.7, -0.5, 0]) }, undefined, true);
  }

  /// The intervals of the slabs over t, one above the other, and their common part.
  bars(sketch, top, name, parts, inside) {
    const place = (t) => 510 + 34 * Math.max(-3, Math.min(3.4, t)), [letter, ...meaning] = name.split(": ");
    if (inside !== null) sketch.cells([[place(inside.min), top - 19, place(inside.max) - place(inside.min), 38]], { fill: color.faint });
    sketch.pixels("line", { x1: place(0), x2: place(0), y1: top - 22, y2: top + 22 }, { stroke: color.gray, width: 1 });
    sketch.write([place(0), top - 28], "$t$ = 0", color.gray, "middle");
    parts.forEach((part, i) => {
      const y = top - 10 + 20 * i;
      if (part !== null) sketch.pixels("line", { x1: place(part.min), x2: place(part.max), y1: y, y2: y }, { stroke: color.gray, width: 5 });
      sketch.write([part === null ? 470 : place(part.min) - 6, y + 5], part === null ? `$${"xy"[i]}$: never` : `$${"xy"[i]}$`, color.ink, "end");
    });
    if (inside !== null && inside.max > 0) sketch.pixels("circle", { cx: place(inside.min), cy: top, r: 4 }, { fill: color.red });
    sketch.write([382, top + 5], letter, color.blue, "middle", "; font-weight: bold");
    sketch.write([400, top + 42], name ? meaning.join(": ") : inside === null ? "no common part" : `in the box: ${short(inside.min)} ≤ $t$ ≤ ${short(inside.max)}`);
  }

  async draw(sketch) {
    const [x, y] = box.max;
    sketch.polygon([[-x, -2, 0], [x, -2, 0], [x, 2, 0], [-x, 2, 0]], { fill: color.tint });
    sketch.polygon([[-2.4, -y, 0], [2.4, -y, 0], [2.4, y, 0], [-2.4, y, 0]], { fill: color.tint });
    for (const side of [-1, 1]) {
      sketch.line([side * x, -2, 0], [side * x, 2, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
      sketch.line([-2.4, side * y, 0], [2.4, side * y, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
    }
    sketch.polygon([[-x, -y, 0], [x, -y, 0], [x, y, 0], [-x, y, 0]], { fill: color.faint, stroke: color.ink, width: 2 });
    let top = 74;
    for (const [name, ray] of Object.entries(this.rays)) {
      const parts = [];
      for (const slab of slabs) parts.push(await this.ask(13, "overlap", ray, slab, line));
      const inside = await this.ask(13, "overlap", ray, box, line), t = await this.ask(13, "intersect", ray, oriented, ahead);
      if (name) {
        if (inside !== null) sketch.line(at(ray, Math.min(inside.min, 0)), ray.origin, { stroke: color.blue, width: 1.2, dashes: "4 4" });
        sketch.arrow(ray.origin, at(ray, t === null ? 1.3 : inside.max + 0.4), { stroke: color.blue, width: 1.8 });
        sketch.mark(ray.origin, "given");
        sketch.label(ray.origin, [-10, 17], name[0], color.blue, "middle", "; font-weight: bold");
      } else sketch.ray(ray);
      for (const time of parts.filter((part) => part !== null).flatMap(({ min, max }) => [min, max])) if (Number.isFinite(time) && (time > 0 || !name)) sketch.mark(at(ray, time), inside !== null && time === inside.min && t !== null ? "hit" : "refused");
      this.bars(sketch, top, name, parts, inside);
      top += 116;
    }
    [["hit", 22, "enters the box"], ["refused", 178, "crosses another plane"]].forEach(([kind, x, meaning]) => {
      sketch.mark(sketch.world([x, 370]), kind);
      sketch.write([x + 12, 375], meaning);
    });
    const { ray } = this, t = await this.ask(13, "intersect", ray, oriented, ahead), n = t === null ? null : await this.ask(13, "normal", oriented, at(ray, t));
    if (t !== null && !this.together) {
      this.normal(sketch, at(ray, t), n);
      sketch.label(at(ray, t), [12, 22], `$t$ = ${short(t)}`, color.red, "start");
    }
    return [await this.ask(0, "explain", ray, oriented, ahead), ["overlap", await this.ask(13, "overlap", ray, box, line)], ["intersect", t], ["normal", n]];
  }
});
