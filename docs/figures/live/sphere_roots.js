// Stage 3: where a line hits a sphere. Drag the ray's origin, and the tip of its direction.
import { RayFigure, add, ahead, at, color, define, times, toward } from "./drawing.js";

const from = (x, y) => toward([x, y, 0], [1, 0, 0]);

define("sphere_roots", class extends RayFigure {
  view = { place: [390, 165], scale: 106 };
  sphere = { center: [0, 0, 0], radius: 1 };

  setup() {
    super.setup();
    this.cases({ "Δ < 0": from(-2.9, 1.3), "Δ = 0": from(-2.9, 1), "0 < t₁ < t₂": from(-2.9, 0.5), "t₁ < 0 < t₂": from(-0.25, -0.05), "t₁ < t₂ < 0": toward([1.3, -0.6, 0], [0.7, 0, 0]) }, "0 < t₁ < t₂");
    this.far = this.check("a thousand times further away");
  }

  async draw(sketch) {
    const near = this.ray;
    // The picture is the same: the ray starts a thousand directions before.
    const ray = this.far.value ? { ...near, origin: at(near, -1000) } : near;
    const { sphere } = this;
    const t = await this.ask(3, "intersect", ray, sphere, ahead);
    sketch.circle(sphere.center, sphere.radius);
    sketch.ray(near);
    const roots = await this.roots(3, ray, sphere);
    const shown = [];
    if (t !== null) {
      const p = at(ray, t), n = await this.ask(3, "normal", sphere, p);
      shown.push(["normal", n], ["color_from_normal", await this.ask(3, "color_from_normal", n)], ["torch at the ray's origin", await this.ask(3, "torch", p, n, ray.origin)]);
      this.normal(sketch, p, n);
      sketch.label(add(p, times(0.5, n)), [0, -6], "$n$", color.green);
    }
    sketch.roots(ray, roots, t);
    if (t === null) sketch.shape("text", { x: 390, y: 325, text_anchor: "middle" }, "no hit");
    sketch.label(near.origin, [0, -20], "$o_r$");
    sketch.label(at(near, 0.5), [0, -14], "$d_r$", color.blue);
    return [await this.ask(0, "explain", ray, sphere, ahead), ["intersect", t], ...shown];
  }
});
