// Stage 7: the tube cut along its axis, and both roots with their z. Drag the ray.
import { RayFigure, ahead, at, color, define, short, toward } from "./drawing.js";

const ray = (origin, direction) => toward(origin, direction, { height: 2 });

define("cylinder_both_roots", class extends RayFigure {
  static height = 376;
  view = { place: [320, 188], scale: 78 };

  setup() {
    super.setup();
    this.height = this.slider("height h", { min: 0.2, max: 3.6, step: 0.1, value: 2 });
    this.cases({
      "A: t₁ is hit": ray([-2, -0.4, 0], [0.5, 0.05, 0]), "B: t₂ is hit": ray([-2, 2, 0], [0.5, -0.275, 0]), "C: the rim": ray([-2, -1, 0], [0.5, 0, 0]),
      "D: no hit": ray([1.32, 2.1, 0], [-0.5, -0.825, 0]), "E: along the axis": ray([0, 2.1, 0], [0, -0.6, 0]),
    }, "B: t₂ is hit");
  }

  async draw(sketch) {
    const { ray } = this;
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
    if (t !== null) this.normal(sketch, at(ray, t), await this.ask(7, "normal", cylinder, at(ray, t)));
    // The roots that the height refuses: those of a longer tube.
    const roots = await this.roots(7, ray, { ...cylinder, height: 1e3 });
    sketch.roots(ray, roots, t, (root) => `, $z_p$ = ${short(at(ray, root)[1])}`);
    for (const [y, text] of [[h, "$z_p$ = $h$ / 2"], [-h, "$z_p$ = −$h$ / 2"]]) {
      sketch.line([1, y, 0], [1.3, y, 0], { stroke: color.gray, width: 1 });
      sketch.label([1.3, y, 0], [6, 5], text, color.ink, "start");
    }
    sketch.label([0, -2, 0], [12, 0], "$Z$", color.green);
    sketch.shape("text", { x: 20, y: 360 }, t === null ? "no hit" : `hit: $t$ = ${short(t)}`);
    return [await this.ask(0, "explain", ray, cylinder, ahead), ["intersect", t]];
  }
});
