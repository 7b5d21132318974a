// Stage 5: three signed areas, and the weights of the corners. Drag p, and the corners.
import { Figure, ahead, color, define } from "./drawing.js";

define("triangle_areas", class extends Figure {
  static title = "A triangle and a point p in its plane: drag p or a corner";
  view = { place: [320, 190], scale: 95 };

  setup() {
    this.a = this.handle("a", [-1.6, -1.2, 0]);
    this.b = this.handle("b", [1.7, -0.9, 0]);
    this.c = this.handle("c", [-0.2, 1.5, 0]);
    this.p = this.handle("p", [0.1, -0.1, 0], { fill: color.red });
  }

  async draw(sketch) {
    const [a, b, c, p] = [this.a, this.b, this.c, this.p].map((handle) => handle.place);
    const triangle = { a, b, c };
    // The ray arrives at p from the front, at a right angle.
    const ray = { origin: [p[0], p[1], 1], direction: [0, 0, -1] };
    const t = await this.ask(5, "intersect", ray, triangle, ahead);
    const weights = await this.ask(5, "barycentric", triangle, p);
    const parts = [["α", b, c, color.pale_blue], ["β", c, a, color.pale_green], ["γ", a, b, color.pale_amber]];
    parts.forEach(([name, from, to, fill], i) => {
      const negative = weights[i] < 0;
      sketch.polygon([from, to, p], { fill: negative ? color.pale_red : fill, stroke: negative ? color.red : color.gray, width: 1, dashes: negative ? "4 3" : "none" });
      const middle = from.map((x, k) => (x + to[k] + p[k]) / 3);
      sketch.label(middle, [0, 5], negative ? `−${name}` : name, negative ? color.red : color.ink);
    });
    sketch.polygon([a, b, c], { stroke: color.ink, width: 2 });
    [["a", a], ["b", b], ["c", c]].forEach(([name, corner]) => sketch.label(corner, [corner === b ? 20 : -20, 5], name));
    sketch.label(p, [14, 22], t === null ? "p: outside" : "p: hit", t === null ? color.gray : color.red, "start");
    return [await this.ask(0, "explain", ray, triangle, ahead), ["barycentric: α, β, γ", weights], ["intersect", t], ["normal", await this.ask(5, "normal", triangle, p)]];
  }
});
