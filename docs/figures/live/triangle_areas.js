// Stage 5: three signed areas, and the weights of the corners, of a point inside and of one that can be moved. Drag p, and the corners.
import { Figure, Sketch, add, ahead, color, define, times } from "./drawing.js";

const corners = { a: [-1.05, -0.75, 0], b: [1.15, -0.5, 0], c: [-0.25, 0.95, 0] };
const between = (share, p, q) => add(times(1 - share, p), times(share, q));
const decimal = (x) => x.toFixed(2).replace("-", "−");

define("triangle_areas", class extends Figure {
  static height = 326;
  view = { place: [466, 142], scale: 118 };
  left = { place: [160, 142], scale: 118 };

  setup() {
    for (const name of ["a", "b", "c"]) this[name] = this.handle(name);
    this.p = this.handle("p", undefined, { fill: color.red });
    this.cases({ "α < 0": { ...corners, p: [1.1, 0.72, 0] }, "α, β, γ > 0": { ...corners, p: [0.4, -0.2, 0] } });
  }

  draw_areas(sketch, { a, b, c }, p, weights) {
    const parts = [["α", b, c, color.pale_blue], ["β", c, a, color.pale_amber], ["γ", a, b, color.pale_green]].map((part, i) => [...part, weights[i]]);
    // Those with a negative weight lie on the others: hatched, so that the whole of each is seen.
    parts.sort((one, other) => other[4] - one[4]);
    for (const [name, from, to, fill, weight] of parts) {
      sketch.polygon([from, to, p], weight < 0 ? { stroke: color.purple, width: 2 } : { fill, stroke: color.gray, width: 1 });
      for (let i = 1; weight < 0 && i < 10; ++i) sketch.line(between(i / 10, p, from), between(i / 10, p, to), { stroke: color.purple, width: 1 });
      sketch.label(times(1 / 3, add(add(from, to), p)), [name === "β" ? 6 : 0, weight < 0 ? -3 : name === "β" && Math.min(...weights) < 0 ? 13 : 5], `$${name}$ = ${decimal(weight)}`, weight < 0 ? color.purple : color.ink, "middle", weight < 0 ? "; stroke-width: 10" : "");
    }
    sketch.polygon([a, b, c], { stroke: color.ink, width: 2 });
    sketch.mark(p, Math.min(...weights) < 0 ? "refused" : "hit");
    Object.entries({ a, b, c }).forEach(([name, corner]) => sketch.label(corner, [corner === b ? 18 : -18, 8], `$${name}$`));
  }

  async draw(sketch) {
    const [a, b, c, p] = [this.a, this.b, this.c, this.p].map((handle) => handle.place);
    const triangle = { a, b, c };
    // The ray arrives at p from the front, at a right angle.
    const ray = { origin: [p[0], p[1], 1], direction: [0, 0, -1] };
    const t = await this.ask(5, "intersect", ray, triangle, ahead);
    const weights = await this.ask(5, "barycentric", triangle, p), inside = [0, -0.2, 0];
    const left = new Sketch(sketch.group, sketch.labels, { ...sketch.view, ...this.left });
    this.draw_areas(left, corners, inside, await this.ask(5, "barycentric", corners, inside));
    left.label(inside, [12, -8], "$p$", color.red);
    sketch.write([160, 282], "$p$ = $α a$ + $β b$ + $γ c$, and $α$ + $β$ + $γ$ = 1", color.ink, "middle");
    sketch.write([160, 304], "the weight of a corner: the area opposite", color.gray, "middle");
    this.draw_areas(sketch, triangle, p, weights);
    sketch.label(p, t === null ? [0, -14] : [14, 5], t === null ? "$p$: no hit" : "$p$: hit", t === null ? color.gray : color.red, t === null ? "middle" : "start");
    const sum = weights.reduce((total, weight) => total + Math.abs(weight), 0);
    sketch.write([480, 282], t === null ? "an area beyond its edge is negative" : "$p$ is on the inner side of all edges", color.ink, "middle");
    sketch.write([480, 304], `|$α$| + |$β$| + |$γ$| = ${sum.toFixed(2)}`, color.gray, "middle");
    return [await this.ask(0, "explain", ray, triangle, ahead), ["barycentric: α, β, γ", weights], ["intersect", t], ["normal", await this.ask(5, "normal", triangle, p)]];
  }
});
