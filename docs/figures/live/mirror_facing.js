// Stage 12: a ray between two mirrors, and where the recursion ends. Drag the ray.
import { Figure, color, define, minus, short } from "./drawing.js";

const walls = [{ point: [-1.4, 0, 0], normal: [1, 0, 0] }, { point: [1.4, 0, 0], normal: [-1, 0, 0] }];

define("mirror_facing", class extends Figure {
  view = { place: [320, 300], scale: 100 };
  static height = 330;

  setup() {
    this.origin = this.handle("origin");
    this.tip = this.handle("direction", undefined, { fill: color.blue });
    this.mirror = this.slider("mirror", { min: 0, max: 1, step: 0.05, value: 0.6 });
    this.depth = this.slider("depth", { min: 0, max: 24, step: 1, value: 16 });
    const places = { origin: [-0.9, 0.1, 0], tip: [0, 0.165, 0] };
    this.cases({ "weight < 1/512": { ...places, mirror: 0.6, depth: 16 }, "depth 8": { ...places, mirror: 0.9, depth: 8 } });
  }

  async draw(sketch) {
    sketch.label([1.4, 0, 0], [12, 5], "weight", color.gray, "start");
    for (const { point: [x] } of walls) sketch.line([x, -0.2, 0], [x, 3, 0], { width: 4 });
    let ray = { origin: this.origin.place, direction: minus(this.tip.place, this.origin.place) };
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
      const beside = [surface.point, [surface.point[0] < 0 ? -12 : 12, 5], color.ink, surface.point[0] < 0 ? "end" : "start"];
      const tell = (text, fill = beside[2]) => sketch.label(beside[0], beside[1], text, fill, beside[3]);
      if (bounces < 14) tell(short(weight));
      if (!(await this.ask(12, "worth_reflecting", bounces, this.depth.value, weight))) {
        tell(`${short(weight)}: ${bounces >= this.depth.value ? "the depth" : "< 1/512"}`, color.red);
        reason = bounces >= this.depth.value ? "the depth is reached" : "what is reflected is not visible: weight below 1/512";
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
