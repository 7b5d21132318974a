// Stage 6: a square in its own frame: x, y against h / 2, and HAI's u and v. Drag the ray's end.
import { Figure, add, ahead, color, define, times } from "./drawing.js";

define("square_frame", class extends Figure {
  static title = "A square and a point in its plane: drag the point, turn the square";
  view = { place: [320, 170], scale: 85 };

  setup() {
    this.center = this.handle("center", [0.2, 0.1, 0]);
    this.p = this.handle("p", [0.8, 0.5, 0], { fill: color.red });
    this.angle = this.slider("turned by", { min: -90, max: 90, step: 5, value: 20, unit: "°" });
    this.side = this.slider("side h", { min: 0.2, max: 3, step: 0.1, value: 2 });
    this.one_sided = this.check("one-sided");
    this.behind = this.check("from behind");
  }

  async draw(sketch) {
    const [o, p, h] = [this.center.place, this.p.place, this.side.value];
    const angle = (this.angle.value * Math.PI) / 180, [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const basis = { x: [cos, sin, 0], y: [-sin, cos, 0], z: [0, 0, 1] };
    const square = { center: o, basis, side: h, one_sided: this.one_sided.value };
    const from = this.behind.value ? -2 : 2;
    const ray = { origin: [p[0], p[1], from], direction: [0, 0, -from / 2] };
    const t = await this.ask(6, "intersect", ray, square, ahead);
    const beyond = await this.ask(6, "intersect", ray, square, { min: 3, max: Infinity });
    const away = await this.ask(6, "intersect", { ...ray, direction: times(-1, ray.direction) }, square, ahead);
    const uv = await this.ask(6, "square_uv", square, p);
    const corner = (x, y) => add(o, add(times((x * h) / 2, basis.x), times((y * h) / 2, basis.y)));
    sketch.polygon([corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1)], { fill: color.tint, stroke: color.ink, width: 2 });
    sketch.arrow(o, add(o, basis.x), { stroke: color.green, width: 2 });
    sketch.arrow(o, add(o, basis.y), { stroke: color.green, width: 2 });
    sketch.label(add(o, basis.x), [14, 5], "X", color.green);
    sketch.label(add(o, basis.y), [0, -10], "Y", color.green);
    sketch.label(corner(-1, -1), [-14, 16], "C: u = v = 0");
    // The two coordinates of p: along X from C, then along Y.
    const along = add(corner(-1, -1), times(uv[0] * h, basis.x));
    sketch.line(corner(-1, -1), along, { stroke: color.amber, width: 2 });
    sketch.line(along, p, { stroke: color.amber, width: 2, dashes: "5 4" });
    sketch.mark(p, t === null ? "refused" : "hit");
    sketch.label(p, [14, -8], t === null ? "missed" : "hit", t === null ? color.gray : color.red, "start");
    return [await this.ask(0, "explain", ray, square, ahead), ["square_uv: u, v", uv], ["intersect", t], ["intersect from t = 3 on", beyond], ["intersect of the ray away from it", away], ["normal", await this.ask(6, "normal", square, p)]];
  }
});
