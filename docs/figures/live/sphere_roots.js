// Stage 3: where a line hits a sphere. Drag the ray's origin, and the tip of its direction.
import { Figure, ahead, at, color, define, minus, times } from "./drawing.js";

define("sphere_roots", class extends Figure {
  static title = "A ray and a sphere: drag the origin of the ray, or the tip of its direction";
  view = { place: [350, 170], scale: 95 };
  sphere = { center: [0, 0, 0], radius: 1 };

  setup() {
    this.origin = this.handle("origin", [-2.6, 0.5, 0]);
    this.tip = this.handle("direction", [-1.6, 0.5, 0], { fill: color.blue });
    this.far = this.check("a thousand times further away");
  }

  async draw(sketch) {
    const near = { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
    // The picture is the same: the ray starts a thousand directions before.
    const ray = this.far.value ? { ...near, origin: at(near, -1000) } : near;
    const { sphere } = this;
    const t = await this.ask(3, "intersect", ray, sphere, ahead);
    sketch.circle(sphere.center, sphere.radius);
    sketch.ray(near);
    for (const root of await this.roots(3, ray, sphere)) if (root !== t) sketch.mark(at(ray, root), "refused");
    const shown = [];
    if (t !== null) {
      const p = at(ray, t), n = await this.ask(3, "normal", sphere, p);
      shown.push(["normal", n], ["color_from_normal", await this.ask(3, "color_from_normal", n)], ["torch at the ray's origin", await this.ask(3, "torch", p, n, ray.origin)]);
      sketch.arrow(p, [0, 1, 2].map((i) => p[i] + n[i] / 2), { stroke: color.green });
      sketch.mark(p, "hit");
    }
    sketch.label(near.origin, [0, -14], "o_r");
    sketch.label(at(near, 0.5), [0, -10], "d_r", color.blue);
    return [await this.ask(0, "explain", ray, sphere, ahead), ["intersect", t], ...shown];
  }
});
