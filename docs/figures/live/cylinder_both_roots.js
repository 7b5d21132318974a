// Stage 7: the tube cut along its axis, and both roots with their z. Drag the ray.
import { RayFigure, ahead, at, color, define, short, toward } from "./drawing.js";

const ray = (origin, direction) => toward(origin, direction, { height: 2 });

define("cylinder_both_roots", class extends RayFigure {
  static height = 376;
  view = { place: [196, 188], scale: 78 };

  setup() {
    super.setup();
    this.height = this.slider("height h", { min: 0.2, max: 3.6, step: 0.1, value: 2 });
    this.cases({
      "A: the near root is within: a hit": ray([-2, -0.4, 0], [0.5, 0.05, 0]), "B: $z_p$ > $h$ / 2 at $t_1$: $t_2$ is hit": ray([-2, 2, 0], [0.5, -0.275, 0]), "C: |$z_p$| = $h$ / 2: the rim belongs": ray([-2, -1, 0], [0.5, 0, 0]),
      "D: neither root is within: missed": ray([1.32, 2.1, 0], [-0.5, -0.825, 0]), "E: along the axis $a$ = 0: missed": ray([0, 2.1, 0], [0, -0.6, 0]),
    }, "B: $z_p$ > $h$ / 2 at $t_1$: $t_2$ is hit", true);
  }

  async draw(sketch) {
    const cylinder = { center: [0, 0, 0], axis: [0, 1, 0], radius: 1, height: this.height.value };
    const h = cylinder.height / 2;
    sketch.polygon([[-1, -h, 0], [1, -h, 0], [1, h, 0], [-1, h, 0]], { fill: color.tint });
    for (const x of [-1, 1]) {
      sketch.line([x, -3, 0], [x, 3, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
      sketch.line([x, -h, 0], [x, h, 0], { width: 3 });
    }
    sketch.line([0, -2.2, 0], [0, 2.2, 0], { stroke: color.green, width: 1, dashes: "8 4" });
    const look = async (ray) => {
      const t = await this.ask(7, "intersect", ray, cylinder, ahead);
      // The roots that the height refuses: those of a longer tube.
      return { t, n: t === null ? null : await this.ask(7, "normal", cylinder, at(ray, t)), roots: await this.roots(7, ray, { ...cylinder, height: 1e3 }) };
    };
    await this.draw_rays(sketch, look, { key: [396, 96], told: (root) => `, $z_p$ = ${short(at(this.ray, root)[1])}` });
    for (const [y, text] of [[h, "$z_p$ = $h$ / 2"], [-h, "$z_p$ = −$h$ / 2"]]) {
      sketch.line([1, y, 0], [1.3, y, 0], { stroke: color.gray, width: 1 });
      sketch.label([1.3, y, 0], [6, y < 0 ? 20 : 5], text, color.ink, "start");
    }
    sketch.arrow([0, 1.9, 0], [0, 2.25, 0], { stroke: color.green, width: 2 });
    sketch.label([0, 2, 0], [14, 5], "$Z$", color.green);
    const t = await this.ask(7, "intersect", this.ray, cylinder, ahead);
    if (!this.together) sketch.write([620, 338], t === null ? "no hit" : `hit: $t$ = ${short(t)}`, color.ink, "end");
    return [await this.ask(0, "explain", this.ray, cylinder, ahead), ["intersect", t]];
  }
});
