// Stage 12: a ray between two mirrors, and where the recursion ends. Drag the ray.
import { RayFigure, color, define, short, toward } from "./drawing.js";

const walls = [{ point: [-1.4, 0, 0], normal: [1, 0, 0] }, { point: [1.4, 0, 0], normal: [-1, 0, 0] }];

define("mirror_facing", class extends RayFigure {
  view = { place: [320, 300], scale: 100 };
  static height = 330;

  setup() {
    super.setup();
    this.mirror = this.slider("mirror", { min: 0, max: 1, step: 0.05, value: 0.6 });
    this.depth = this.slider("depth", { min: 0, max: 24, step: 1, value: 16 });
    const between = (mirror, depth) => toward([-0.9, 0.1, 0], [0.9, 0.065, 0], { mirror, depth });
    this.cases({ "weight < 1/512": between(0.6, 16), "depth 8": between(0.9, 8) });
  }

  async draw(sketch) {
    sketch.label([1.4, 0, 0], [12, 5], "reflected weight", color.gray, "start");
    [`$m$ = ${this.mirror.value}`, `depth ${this.depth.value}`].forEach((text, i) => sketch.write([20, 290 + 22 * i], text));
    sketch.label(this.origin.place, [0, 24], "eye");
    for (const { point: [x] } of walls) sketch.line([x, -0.2, 0], [x, 3, 0], { width: 4 });
    let { ray } = this;
    let [bounces, weight] = [0, 1], reason = "the ray leaves";
    const rows = [];
    const pen = () => ({ stroke: color.blue, width: 0.6 + 3 * weight });
    sketch.arrow(ray.origin, this.tip.place, { stroke: color.blue, width: 4 });
    while (bounces < 40) {
      const wall = walls[ray.direction[0] < 0 ? 0 : 1];
      const surface = await this.ask(0, "shade", ray, wall);
      if (surface === null || surface.point[1] > 3) {
        const length = Math.hypot(...ray.direction) || 1;
        sketch.line(ray.origin, ray.origin.map((x, i) => x + (4 * ray.direction[i]) / length), pen());
        break;
      }
      sketch.line(ray.origin, surface.point, pen());
      sketch.mark(surface.point, bounces ? "foot" : "hit");
      weight *= this.mirror.value;
      const ends = !(await this.ask(12, "worth_reflecting", bounces, this.depth.value, weight)), too_deep = bounces >= this.depth.value;
      const why = ends ? (too_deep ? ": the depth" : " < 1/512") : "", [x] = surface.point;
      sketch.label(surface.point, [x < 0 ? -12 : 12, 5], (["$m$ = ", "$m$² = ", "$m$³ = "][bounces] ?? "") + short(weight, 2) + why, color.ink, x < 0 ? "end" : "start");
      if (ends) {
        reason = too_deep ? "the depth is reached" : "what is reflected is not visible: weight below 1/512";
        sketch.mark(surface.point, "refused");
        break;
      }
      surface.material.mirror = this.mirror.value;
      ray = await this.ask(12, "mirrored", ray, surface);
      rows.push([`reflection ${++bounces}, weight ${weight.toPrecision(3)}`, ray.direction]);
    }
    const mixed = await this.ask(12, "mixed", [0, 0, 0], [1, 1, 1], this.mirror.value);
    return [["mixed: black with a white reflection", mixed], ["reflections", `${bounces}: ${reason}`], ...rows.slice(0, 6)];
  }
});
