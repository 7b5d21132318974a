// Stage 7: the tube cut along its axis, and both roots with their z. Drag the ray.
import { Figure, ahead, at, color, define, minus } from "./drawing.js";

define("cylinder_both_roots", class extends Figure {
  static title = "A tube cut along its axis, and a ray: drag the origin, or the direction";
  view = { place: [320, 170], scale: 80 };

  setup() {
    this.origin = this.handle("origin", [-2.6, 1.9, 0]);
    this.tip = this.handle("direction", [-1.6, 1.3, 0], { fill: color.blue });
    this.height = this.slider("height h", { min: 0.2, max: 3.6, step: 0.1, value: 2 });
  }

  async draw(sketch) {
    const ray = { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
    const cylinder = { center: [0, 0, 0], axis: [0, 1, 0], radius: 1, height: this.height.value };
    const h = cylinder.height / 2;
    sketch.polygon([[-1, -h, 0], [1, -h, 0], [1, h, 0], [-1, h, 0]], { fill: color.tint });
    for (const x of [-1, 1]) {
      sketch.line([x, -3, 0], [x, 3, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
      sketch.line([x, -h, 0], [x, h, 0], { width: 3 });
    }
    sketch.line([0, -2, 0], [0, 2, 0], { stroke: color.green, width: 1, dashes: "8 4" });
    sketch.ray(ray);
    const t = await this.ask(7, "intersect", ray, cylinder, ahead);
    // The roots that the height refuses: those of a longer tube.
    for (const root of await this.roots(7, ray, { ...cylinder, height: 1e3 })) if (root !== t) sketch.mark(at(ray, root), "refused");
    if (t !== null) {
      const p = at(ray, t), n = await this.ask(7, "normal", cylinder, p);
      sketch.arrow(p, p.map((x, i) => x + n[i] / 2), { stroke: color.green });
      sketch.mark(p, "hit");
    }
    sketch.label([1, h, 0], [30, 4], "h / 2");
    sketch.label([0, -2, 0], [12, 0], "Z", color.green);
    return [await this.ask(0, "explain", ray, cylinder, ahead), ["intersect", t]];
  }
});
