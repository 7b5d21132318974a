// Stage 5: three signed areas, and the weights of the corners. Drag p, and the corners.
import { Figure, add, ahead, color, define, times } from "./drawing.js";

const corners = { a: [-1.05, -0.75, 0], b: [1.15, -0.5, 0], c: [-0.25, 0.95, 0] };
const between = (share, p, q) => add(times(1 - share, p), times(share, q));

define("triangle_areas", class extends Figure {
  view = { place: [300, 185], scale: 150 };

  setup() {
    for (const name of ["a", "b", "c"]) this[name] = this.handle(name);
    this.p = this.handle("p", undefined, { fill: color.red });
    this.cases({ "α < 0": { ...corners, p: [1.1, 0.72, 0] }, "α, β, γ > 0": { ...corners, p: [0, -0.2, 0] } });
  }

  async draw(sketch) {
    const [a, b, c, p] = [this.a, this.b, this.c, this.p].map((handle) => handle.place);
    const triangle = { a, b, c };
    // The ray arrives at p from the front, at a right angle.
    const ray = { origin: [p[0], p[1], 1], direction: [0, 0, -1] };
    const t = await this.ask(5, "intersect", ray, triangle, ahead);
    const weights = await this.ask(5, "barycentric", triangle, p);
    const parts = [["α", b, c, color.pale_blue], ["β", c, a, color.pale_amber], ["γ", a, b, color.pale_green]].map((part, i) => [...part, weights[i]]);
    // Those with a negative weight lie on the others: hatched, so that the whole of each is seen.
    parts.sort((one, other) => other[4] - one[4]);
    for (const [, from, to, fill, weight] of parts) {
      sketch.polygon([from, to, p], weight < 0 ? { stroke: color.red, width: 2 } : { fill, stroke: color.gray, width: 1 });
      for (let i = 1; weight < 0 && i < 10; ++i) sketch.line(between(i / 10, p, from), between(i / 10, p, to), { stroke: color.red, width: 1 });
    }
    sketch.polygon([a, b, c], { stroke: color.ink, width: 2 });
    for (const [name, from, to, , weight] of parts)
      sketch.label(times(1 / 3, add(add(from, to), p)), [0, 5], `$${name}$ = ${weight.toFixed(2).replace("-", "−")}`, weight < 0 ? `${color.red}; stroke-width: 10` : color.ink);
    [["a", a], ["b", b], ["c", c]].forEach(([name, corner]) => sketch.label(corner, [corner === b ? 20 : -20, 5], `$${name}$`));
    sketch.label(p, [14, -10], t === null ? "$p$: no hit" : "$p$: hit", t === null ? color.gray : color.red, "start");
    const sum = weights.reduce((total, weight) => total + Math.abs(weight), 0);
    sketch.shape("text", { x: 620, y: 325, text_anchor: "end" }, `|$α$| + |$β$| + |$γ$| = ${sum.toFixed(2)}`);
    return [await this.ask(0, "explain", ray, triangle, ahead), ["barycentric: α, β, γ", weights], ["intersect", t], ["normal", await this.ask(5, "normal", triangle, p)]];
  }
});
