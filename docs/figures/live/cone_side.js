// Stage 8: the hourglass of the equation, the sign of A, and the nappe that is the cone. Drag the ray.
import { Figure, ahead, at, color, define, minus } from "./drawing.js";

define("cone_side", class extends Figure {
  static title = "A cone cut along its axis, with its second nappe, and a ray: drag the origin, or the direction";
  view = { place: [320, 170], scale: 75 };

  setup() {
    this.origin = this.handle("origin", [-2.8, -0.6, 0]);
    this.tip = this.handle("direction", [-1.7, -0.5, 0], { fill: color.blue });
    this.radius = this.slider("radius r", { min: 0.2, max: 2, step: 0.1, value: 1 });
    this.height = this.slider("height h", { min: 0.3, max: 2, step: 0.1, value: 1.8 });
  }

  async draw(sketch) {
    const ray = { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
    const [r, h] = [this.radius.value, this.height.value];
    const cone = { apex: [0, 0, 0], axis: [0, -1, 0], radius: r, height: h };
    sketch.polygon([[0, 0, 0], [r, -h, 0], [-r, -h, 0]], { fill: color.tint });
    for (const x of [-r, r]) {
      sketch.line([2 * x, -2 * h, 0], [-2 * x, 2 * h, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
      sketch.line([0, 0, 0], [x, -h, 0], { width: 3 });
    }
    sketch.arrow([0, 0, 0], [0, -h / 2, 0], { stroke: color.green, width: 2 });
    sketch.label([0, -h / 2, 0], [12, 0], "Z", color.green);
    sketch.label([0, 1, 0], [0, 0], "the second nappe: z_p < 0", color.gray);
    sketch.ray(ray);
    const t = await this.ask(8, "intersect", ray, cone, ahead);
    // The roots of the equation that the cone refuses: those of two longer cones, apex to apex.
    for (const axis of [[0, -1, 0], [0, 1, 0]])
      for (const root of await this.roots(8, ray, { ...cone, axis, radius: 500 * r, height: 500 * h })) if (root !== t) sketch.mark(at(ray, root), "refused");
    if (t !== null) {
      const p = at(ray, t), n = await this.ask(8, "normal", cone, p);
      sketch.arrow(p, p.map((x, i) => x + n[i] / 2), { stroke: color.green });
      sketch.mark(p, "hit");
    }
    const explanation = await this.ask(0, "explain", ray, cone, ahead);
    const a = Number(/A, B, C = ([^,]*),/.exec(explanation)?.[1]);
    return [explanation, ["A", a > 0 ? "positive: the ray is flatter than the surface" : a < 0 ? "negative: it is steeper, and each nappe is hit once" : "0: parallel to the surface, one root"], ["intersect", t]];
  }
});
