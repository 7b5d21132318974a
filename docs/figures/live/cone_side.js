// Stage 8: the hourglass of the equation, the sign of a, and the nappe that is the cone. Drag the ray.
import { RayFigure, ahead, at, color, define, short, toward } from "./drawing.js";

const ray = (origin, direction) => toward(origin, direction, { radius: 1, height: 1.7 });

define("cone_side", class extends RayFigure {
  static height = 380;
  view = { place: [210, 252], scale: 94 };

  setup() {
    super.setup();
    this.radius = this.slider("radius r", { min: 0.2, max: 2, step: 0.1, value: 1 });
    this.height = this.slider("height h", { min: 0.3, max: 2, step: 0.1, value: 1.7 });
    this.cases({
      "A: the near root is within: a hit": ray([-1.8, 0.62, 0], [1, -0.1, 0]), "B: $z_p$ < 0 at $t_1$: no nappe, $t_2$ is hit": ray([-0.085, -0.95, 0], [0.15, 0.5, 0]),
      "C: $z_p$ > $h$ at $t_1$: $t_2$ is hit": ray([-1.8, 2.15, 0], [1, -0.309, 0]), "D: along the side $a$ = 0: one root": ray([1.376, -0.3, 0], [-0.4, 0.68, 0]),
    }, "B: $z_p$ < 0 at $t_1$: no nappe, $t_2$ is hit", true);
  }

  async draw(sketch) {
    const [r, h] = [this.radius.value, this.height.value];
    const cone = { apex: [0, 0, 0], axis: [0, 1, 0], radius: r, height: h };
    sketch.polygon([[0, 0, 0], [r, h, 0], [-r, h, 0]], { fill: color.tint });
    for (const x of [-r, r]) {
      sketch.line([-2 * x, -2 * h, 0], [2 * x, 2 * h, 0], { stroke: color.gray, width: 1, dashes: "4 4" });
      sketch.line([0, 0, 0], [x, h, 0], { width: 3 });
    }
    sketch.arrow([0, 0, 0], [0, 2.3, 0], { stroke: color.green, width: 2 });
    sketch.label([0, 2.3, 0], [14, 8], "$Z$", color.green);
    sketch.mark([0, 0, 0], "given");
    sketch.label([0, 0, 0], [-14, 8], "$o$");
    sketch.line([0, h, 0], [r, h, 0], { stroke: color.gray, width: 1 });
    sketch.label([r / 2, h, 0], [4, -8], "$r$");
    sketch.label([0, h / 2, 0], [10, -12], "$h$", color.ink, "start");
    sketch.label([0.8, -1, 0], [0, 0], "$z_p$ < 0", color.gray, "start");
    sketch.label([r, h, 0], [14, 5], "$z_p$ = $h$", color.gray, "start");
    const look = async (ray) => {
      const t = await this.ask(8, "intersect", ray, cone, ahead), roots = [];
      // The roots of the equation that the cone refuses: those of two longer cones, apex to apex.
      for (const axis of [[0, 1, 0], [0, -1, 0]]) roots.push(...await this.roots(8, ray, { ...cone, axis, radius: 512 * r, height: 512 * h }));
      return { t, n: t === null ? null : await this.ask(8, "normal", cone, at(ray, t)), roots };
    };
    await this.draw_rays(sketch, look, { key: [392, 120], told: (root) => `, $z_p$ = ${short(at(this.ray, root)[1])}`, end: () => 2.7 });
    const explanation = await this.ask(0, "explain", this.ray, cone, ahead);
    const a = Number(/A, B, C = ([^,]*),/.exec(explanation)?.[1]);
    if (!this.together) sketch.write([620, 318], `$a$ = ${short(a)}`, color.ink, "end");
    if (!this.together) sketch.write([620, 342], Math.abs(a) < 1e-9 ? "parallel to the side" : a > 0 ? "flatter than the side" : "steeper than the side", color.ink, "end");
    return [explanation, ["intersect", await this.ask(8, "intersect", this.ray, cone, ahead)]];
  }
});
