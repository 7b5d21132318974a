// Stage 3: where a line hits a sphere. Drag the ray's origin, and the tip of its direction.
import { RayFigure, add, ahead, at, color, define, times, toward } from "./drawing.js";

const left = -1.9;
const from = (x, y) => toward([x, y, 0], [0.7, 0, 0]);

define("sphere_roots", class extends RayFigure {
  view = { place: [415, 165], scale: 106 };

  setup() {
    super.setup();
    this.cases({ "Δ < 0: passes by": from(left, 1.3), "Δ = 0: touches": from(left, 1), "0 < $t_1$ < $t_2$: from outside": from(left, 0.5), "$t_1$ < 0 < $t_2$: from inside": from(-0.25, -0.05), "$t_1$ < $t_2$ < 0: behind": from(1.25, -0.6) }, "0 < $t_1$ < $t_2$: from outside", true);
    this.far = this.check("a thousand times further away");
  }

  async draw(sketch) {
    const sphere = { center: [0, 0, 0], radius: 1 };
    // The picture is the same: the ray starts a thousand directions before.
    const moved = (ray) => (this.far.value ? { ...ray, origin: at(ray, -1000) } : ray);
    const look = async (near) => {
      const ray = moved(near), t = await this.ask(3, "intersect", ray, sphere, ahead);
      return { ray, t, n: t === null ? null : await this.ask(3, "normal", sphere, at(ray, t)), roots: await this.roots(3, ray, sphere) };
    };
    sketch.circle(sphere.center, sphere.radius);
    for (const [name, { origin }] of this.together ? Object.entries(this.rays) : []) {
      sketch.line([left, origin[1], 0], origin, { stroke: color.blue, width: 1.2, dashes: "4 4" });
      sketch.label([left, origin[1], 0], [-14, 5], name, color.ink, "end");
    }
    await this.draw_rays(sketch, look, { end: ({ origin }) => 2 - origin[0] });
    const { ray, t, n } = await look(this.ray), shown = [];
    if (t !== null) {
      const p = at(ray, t);
      shown.push(["normal", n], ["color_from_normal", await this.ask(3, "color_from_normal", n)], ["torch at the ray's origin", await this.ask(3, "torch", p, n, ray.origin)]);
      if (!this.together) sketch.label(add(p, times(0.62, n)), n[1] > 0.9 ? [14, 5] : [0, 18], "$n$", color.green);
    }
    if (t === null && !this.together) sketch.write([415, 325], "no hit", color.ink, "middle");
    if (this.together) {
      [["hit", 40, "hit: the smallest $t$ > 0"], ["refused", 240, "a root, refused"]].forEach(([kind, x, meaning]) => {
        sketch.mark(sketch.world([x, 320]), kind);
        sketch.write([x + 12, 325], meaning);
      });
      sketch.line(sketch.world([390, 320]), sketch.world([424, 320]), { stroke: color.blue, width: 1.2, dashes: "4 4" });
      sketch.write([432, 325], "$t$ < 0");
      sketch.arrow(sketch.world([506, 320]), sketch.world([540, 320]), { stroke: color.green, width: 2 });
      sketch.write([548, 325], "$n$");
    } else {
      sketch.label(this.origin.place, [0, -20], "$o_r$");
      sketch.label(at(this.ray, 0.5), [0, -14], "$d_r$", color.blue);
    }
    return [await this.ask(0, "explain", ray, sphere, ahead), ["intersect", t], ...shown];
  }
});
